// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/identify/record_question.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <fstream>
#include <mutex>
#include <stdexcept>

#include "core/numeric/available_threads.h"
#include "core/signal/signal_option.h"
#include "core/study/identify/option_words.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

[[noreturn]] void refuseRecord(const Message& reason) {
    throw std::runtime_error(translated(reason).toStdString());
}

}  // namespace

Scenario scenarioForRecord(Scenario scenario, LawChoice law) {
    if (law != LawChoice::file) scenario.bitRock = {};
    scenario.drill = {};
    return scenario;
}

QString missingIn(const RecordQuestion& question) {
    if (!hasUnits(question.scenario))
        return tr(
            "Identify needs a scenario with physical units: a record of a gauge is in seconds and "
            "newtons. Edit ▸ Make a rig of these groups makes one.");
    if (question.paths.isEmpty())
        return tr(
            "Identify reads stiffness and elasticity of the rock, and the gap between bit and rock, from "
            "strain gauges on the rod. Open a record of one blow, or of several blows along a hole.");
    if (question.gauges.empty()) return tr("Choose the column of the gauge.");
    for (const GaugeChoice& gauge : question.gauges) {
        if (!(gauge.distance > 0))
            return tr("Type the distance of gauge %1 from the bit face.").arg(fromView(gauge.name()));
        if (!gaugePlace(question.scenario, gauge.distance))
            return tr("Gauge %1 is not on a uniform section of the rod or string: correct its distance "
                      "from the bit face.")
                .arg(fromView(gauge.name()));
    }
    return translated(gaugePairProblem(question.gauges, gaugePlaces(question.scenario, question.gauges)));
}

QStringList recordNames(const QStringList& paths) {
    QStringList names;
    for (const QString& path : paths) names << QFileInfo(path).fileName();
    for (qsizetype i = 0; i < names.size(); ++i)
        if (names.count(QFileInfo(paths[i]).fileName()) > 1) names[i] = QDir::toNativeSeparators(paths[i]);
    return names;
}

IdentifiedRecordPtr identifiedRecord(const RecordQuestion& question,
                                     const StudyFeed<IdentifiedRecordPtr>& feed) {
    auto answer = std::make_shared<IdentifiedRecord>();
    answer->question = question;
    IdentifyQuestion& asked = answer->report.question;
    asked.scenario = question.scenario;
    asked.law = question.law;
    asked.dispersion = question.dispersion;
    asked.barBehind = question.barBehind;
    asked.allBlows = question.allBlows;
    asked.known = question.known;
    const QStringList names = recordNames(question.paths);
    for (qsizetype i = 0; i < names.size(); ++i) {
        const std::string file = names[i].toStdString();
        std::ifstream in(QFile::encodeName(question.paths[i]).toStdString(), std::ios::binary);
        if (!in) refuseRecord(about(file, translatable("cannot be read")));
        GaugeReading reading = readGauges(in, question.settings, question.gauges,
                                          gaugePlaces(question.scenario, question.gauges), feed.stop);
        if (feed.stop.stop_requested()) return answer;
        if (!reading.problem.isEmpty()) refuseRecord(about(file, reading.problem));
        if (!reading.questions.empty())
            refuseRecord(
                {translatable("%1: the table does not state this: %2. Open the record again and choose it."),
                 {file, reading.questions.front()}});
        reading.record.file = file;
        asked.records.push_back(std::move(reading.record));
    }
    if (const std::vector<Message> problems = identifyProblems(asked); !problems.empty())
        refuseRecord(inOneLine(problems));
    std::mutex lock;
    std::vector<RecordAnswer> done, first;  // whose other laws are still being tried
    const auto show = [&] {
        auto shown = std::make_shared<IdentifiedRecord>(*answer);
        shown->isPartial = true;
        std::vector<RecordAnswer>& records = shown->report.findings.records;
        records = done;
        records.insert(records.end(), first.begin(), first.end());
        std::ranges::stable_sort(
            records, {}, [&](const RecordAnswer& each) { return names.indexOf(fromView(each.file)); });
        feed.show(shown);
    };
    const auto addDone = [&](const IdentifyFindings& findings) {
        const std::lock_guard hold(lock);
        done = findings.records;
        std::erase_if(first, [&](const RecordAnswer& each) {
            return each.file == done.back().file && each.blow == done.back().blow;
        });
        feed.tell({done.size(), std::max(done.size(), asked.records.size())});
        if (asked.records.size() > 1) show();
    };
    const auto addFirst = [&](RecordAnswer answered) {
        const std::lock_guard hold(lock);
        first.push_back(std::move(answered));
        show();
    };
    answer->report.findings = runIdentify(asked, availableThreads(), feed.stop, addDone, addFirst);
    return answer;
}

QStringList identifyWords(const RecordQuestion& question) {
    QStringList words{QStringLiteral("identify"), QStringLiteral("--signals")};
    for (const QString& path : question.paths) words << QDir::toNativeSeparators(path);
    const auto add = [&words](const char* option, std::string_view value) {
        words << QLatin1String(option) << fromView(value);
    };
    for (const GaugeChoice& gauge : question.gauges) add("--gauge", gaugeWord(gauge));
    if (question.law != LawChoice::automatic) add("--law", lawChoiceNames[question.law]);
    if (question.allBlows) add("--blows", "all");
    if (question.barBehind) add("--backing", "bar");
    if (question.dispersion != DispersionChoice::fit)
        add("--dispersion", dispersionChoiceNames[question.dispersion]);
    for (const KnownTolerance& known : question.known) add("--known", knownWord(known));
    for (const auto& [name, value] : recorderSettings(question.settings)) {
        words << QStringLiteral("--") + fromView(name);
        if (!value.empty()) words << fromView(value);
    }
    return words;
}

}  // namespace drillwave
