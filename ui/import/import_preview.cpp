// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_preview.h"

#include <QFile>
#include <algorithm>
#include <fstream>

#include "core/blow/thinned_blow.h"
#include "core/disk/file_bytes.h"
#include "ui/text/shown_text.h"
#include "ui/text/translation.h"

namespace drillwave {
namespace {

// Of a record with more samples than pixels the lowest and the highest of each bunch.
QPolygonF visibleRecord(const Samples& samples, const SignalRecipe& recipe, double zero) {
    constexpr std::size_t bunches = 2000;
    const std::size_t count = samples.time.size();
    const std::size_t bunch = std::max<std::size_t>(1, count / bunches);
    QPolygonF points;
    const auto add = [&](std::size_t i) {
        points.append({samples.time[i], recipe.forcePerNumber * (samples.value[i] - zero)});
    };
    for (std::size_t i = 0; i < count; i += bunch) {
        const auto begin = samples.value.begin() + static_cast<std::ptrdiff_t>(i);
        const auto end = samples.value.begin() + static_cast<std::ptrdiff_t>(std::min(i + bunch, count));
        auto [low, high] = std::minmax_element(begin, end);
        if (low > high) std::swap(low, high);
        add(static_cast<std::size_t>(low - samples.value.begin()));
        if (low != high) add(static_cast<std::size_t>(high - samples.value.begin()));
    }
    return points;
}

QString problemOf(const Samples& samples) {
    const QString text = QString::fromStdString(samples.problem);
    return samples.problemLine == 0 ? text : tr("line %1: %2").arg(samples.problemLine).arg(text);
}

Samples readFile(const ImportQuestion& question, const StudyFeed<ImportPreview>& feed) {
    const std::string path = QFile::encodeName(question.path).toStdString();
    Samples none;
    none.problem = translated(readStart(path, 0).problem).toStdString();
    if (!none.problem.empty()) return none;
    std::ifstream in(path, std::ios::binary);
    const auto size = static_cast<std::size_t>(QFile(question.path).size());
    return readSamples(in, question.source, feed.stop, [&](std::uint64_t bytes) {
        feed.tell({static_cast<std::size_t>(bytes), size});
    });
}

}  // namespace

ImportPreview ImportStudy::operator()(const ImportQuestion& question, const StudyFeed<ImportPreview>& feed) {
    Kept& kept = *m_kept;
    const bool known = kept.path == question.path && kept.source == question.source &&
                       kept.samples.problem.empty() && !kept.samples.time.empty();
    if (!known) {
        kept = {};  // never two records at a time
        kept = {question.path, question.source, readFile(question, feed)};
    }
    const Samples& samples = kept.samples;
    ImportPreview preview;
    preview.problem = problemOf(samples);
    preview.estimatedRate = samples.estimatedRate;
    if (!preview.problem.isEmpty()) return preview;
    preview.samples = samples.time.size();
    preview.remarks = qualityRemarks(signalQuality(samples), samples);
    preview.skippedTime = samples.skippedTime;
    preview.hasNulTail = samples.hasNulTail;
    preview.skipped = samples.skipped;
    preview.firstSkipped = samples.firstSkipped;
    preview.time = {samples.time.front(), samples.time.back()};
    preview.aroundPeak = spanAroundPeak(samples, question.recipe);
    preview.signOfPeak = signOfPeak(samples, question.recipe);
    const double zero = zeroOf(samples, question.recipe);
    preview.hasBothSigns = std::ranges::any_of(
        samples.value, [&](double value) { return preview.signOfPeak * (value - zero) < 0; });
    preview.record = visibleRecord(samples, question.recipe, zero);
    preview.signal = question.isThinned
                         ? thinnedBlow(question.scenario, samples, question.recipe, feed.stop).signal
                         : shapedSignal(samples, question.recipe, feed.stop);
    if (question.recipe.use == SignalUse::blow)
        preview.effect =
            thinningEffect(question.scenario, samples, question.recipe, preview.signal, feed.stop);
    return preview;
}

}  // namespace drillwave
