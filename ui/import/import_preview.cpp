// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_preview.h"

#include <QFile>
#include <QFontDatabase>
#include <QLocale>
#include <QScrollBar>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/blow/thinned_blow.h"
#include "core/disk/file_bytes.h"
#include "core/text/handy_text.h"
#include "ui/plot/curve_graph.h"
#include "ui/plot/graph_data.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {

namespace {

// A record with more samples than pixels shows the lowest and the highest of each bunch.
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

constexpr int linesOnShow = 6;
constexpr std::size_t shownBytes = 1000;  // of a line: more is not read by anybody

double largest(const QPolygonF& points) {
    double size = 0;
    for (const QPointF& point : points) size = std::max(size, std::abs(point.y()));
    return size;
}

QCPRange padded(double low, double high) {
    if (!(high > low)) return {low - 1, low + 1};
    const double room = 0.06 * (high - low);
    return {low - room, high + room};
}

constexpr double muchOf = 0.05;  // the impulse, for what clipping adds

constexpr int percentDigits = 2;

QString countText(std::size_t count) {
    return QLocale().toString(static_cast<qulonglong>(count));
}

QString sentence(QString text) {
    if (text.isEmpty()) return text;
    text[0] = text[0].toUpper();
    return text.endsWith(u'?') || text.endsWith(u'.') ? text : text + u'.';
}

// Effect of thinning on the blow of the present rod and rock.
QString effectText(const ThinningEffect& effect) {
    const double change = std::abs(effect.change);
    const QString by = change > effect.error
                           ? tr("by %1").arg(numberText(change, 2, QLocale()))
                           : tr("by less than %1").arg(magnitudeText(effect.error, QLocale()));
    return tr("With the present rod and rock this changes e = %1 %2.")
        .arg(numberText(effect.cor, 4, QLocale()), by);
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

FileLines::FileLines(QWidget* parent) : QPlainTextEdit(parent) {
    setObjectName(QStringLiteral("lines"));
    setAccessibleName(tr("First lines of the file"));
    setToolTip(tr("First lines of the file; samples begin at the marked one"));
    setReadOnly(true);
    setTabChangesFocus(true);
    setLineWrapMode(QPlainTextEdit::NoWrap);
    setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    setFixedHeight(linesOnShow * fontMetrics().lineSpacing() + horizontalScrollBar()->sizeHint().height() +
                   12);
}

void FileLines::present(const std::vector<std::string>& lines, std::size_t firstSample) {
    QStringList shown;
    const int digits = lines.size() < 1000 ? 3 : 4;
    for (std::size_t i = 0; i < lines.size(); ++i)
        shown.append(QStringLiteral("%1%2  %3")
                         .arg(i + 1 == firstSample ? QLatin1Char('>') : QLatin1Char(' '))
                         .arg(i + 1, digits)
                         .arg(QString::fromStdString(lines[i].substr(0, shownBytes))));
    setPlainText(shown.join(QLatin1Char('\n')));
    constexpr int above = 3;
    verticalScrollBar()->setValue(std::max(0, static_cast<int>(firstSample) - above));
}

ImportPlot::ImportPlot(PlotWidget* plot, const UnitChoice& units)
    : StudyFrame(plot),
      m_units(units),
      m_record(addCurve(plot->xAxis, plot->yAxis)),
      m_taken(addCurve(plot->xAxis, plot->yAxis)) {
    plot->axisRect()->setupFullAxesBox(true);
    plot->axisRect()->setMinimumMargins(QMargins(4, 4, 12, 4));
    insertAbove(plot->legend);
    useLegend(plot->legend->margins());
    m_record->setName(tr("record"));
    m_taken->setName(tr("used"));
    view(plot->axisRect());
    plot->followPalette([this](const PlotStyle& style) { setStyle(style); });
    connect(plot, &PlotWidget::fitRequested, this, &ImportPlot::fit);
}

void ImportPlot::restyle() {
    m_record->setPen(m_style.ghostPen(0));
    m_taken->setPen(QPen(m_style.lines[1], m_style.lineWidth));
}

void ImportPlot::present(const ImportPreview& preview, double shift, const QString& axis) {
    const Unit& time = m_units.unitFor(UnitKind::time, preview.time.to - preview.time.from);
    const Unit& force = m_units.unitFor(UnitKind::force, largest(preview.record));
    const bool unitsChanged = m_timeFactor != 1 / time.factor() || m_forceUnit != &force;
    m_timeFactor = 1 / time.factor();
    m_forceUnit = &force;
    QVector<QCPGraphData> record, taken;
    for (const QPointF& point : preview.record)
        appendFinite(record, time.fromSi(point.x()), force.fromSi(point.y()));
    for (const TablePoint& point : preview.signal.points)
        appendFinite(taken, time.fromSi(point.time + shift), force.fromSi(point.force));
    m_record->setData(graphData(record));
    m_taken->setData(graphData(taken));
    x()->setLabel(tr("time in the file [%1]").arg(shownUnitName(time.name)));
    y()->setLabel(QStringLiteral("%1 [%2]").arg(axis, shownUnitName(force.name)));
    finish(unitsChanged);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ImportPlot::clear() {
    for (QCPGraph* graph : {m_record, m_taken}) graph->setData(GraphData::create());
}

void ImportPlot::setRanges() {
    bool any = false;
    double left = 0, right = 0, low = 0, high = 0;
    for (const QCPGraph* graph : {m_record, m_taken})
        for (auto point = graph->data()->constBegin(); point != graph->data()->constEnd(); ++point) {
            left = any ? std::min(left, point->key) : point->key;
            right = any ? std::max(right, point->key) : point->key;
            low = std::min(low, point->value);
            high = std::max(high, point->value);
            any = true;
        }
    x()->setRange(any && right > left ? QCPRange(left, right) : padded(left, right));
    y()->setRange(padded(low, high));
}

RecordSpan ImportPlot::visibleTimes() const {
    const QCPRange range = x()->range();
    return {range.lower / m_timeFactor, range.upper / m_timeFactor};
}

QString importSummary(const ImportPreview& preview, const UnitChoice& units) {
    const ShapedSignal& signal = preview.signal;
    const double peak = std::abs(signal.peak);
    QStringList parts;
    parts << tr("Impulse %1, peak %2 at %3 in the file.")
                 .arg(units.text(signal.impulse, UnitKind::impulse), units.text(signal.peak, UnitKind::force),
                      units.text(signal.peakTime, UnitKind::time));
    if (signal.points.size() == signal.samples)
        parts << tr("All of the %1 samples are kept, of %2 in the record.")
                     .arg(countText(signal.samples), countText(preview.samples));
    else
        parts << tr("%1 of %2 samples become %3 points: no sample is further than %4 (%5 of the peak) from "
                    "the lines between the points; the impulse changes by %6.")
                     .arg(countText(signal.samples), countText(preview.samples),
                          countText(signal.points.size()), units.boundText(signal.deviation, UnitKind::force),
                          peak > 0
                              ? percentText(roundedTo(signal.deviation / peak, percentDigits, Rounding::up),
                                            percentDigits, QLocale())
                              : noNumber,
                          units.text(signal.impulseChange, UnitKind::impulse));
    if (preview.effect) parts << effectText(*preview.effect);
    if (signal.clipped > 0)
        parts << tr("%1 negative samples are clipped, which adds %2 to the impulse.")
                     .arg(countText(signal.clipped), units.text(signal.clippedImpulse, UnitKind::impulse));
    if (signal.clippedImpulse > muchOf * std::abs(signal.impulse))
        parts << tr("This is a large change: use a shorter part of the record.");
    if (preview.skipped > 0)
        parts << tr("%1 rows without a number are skipped, the first is line %2.")
                     .arg(countText(preview.skipped), countText(preview.firstSkipped));
    if (preview.skipped > 0 && preview.skippedTime > 0)
        parts << tr("They leave a gap of %1, which is filled by a straight line.")
                     .arg(units.text(preview.skippedTime, UnitKind::time));
    if (preview.hasNulTail) parts << tr("NUL bytes end the table: the recorder did not fill its file.");
    for (const SignalRemark& remark : preview.remarks) parts << sentence(translated(remark.text));
    return parts.join(QLatin1Char(' '));
}

QString importHelp() {
    return tr(
        "Table: separator, decimal sign, the first line with a sample and the columns are found out; change "
        "what is wrong. A unit or a sampling rate that the table does not state has to be "
        "chosen.\n"
        "Signal: force, strain, output of a bridge, voltage, stress or velocity in the unit of the column. A "
        "strain becomes a force by E and the area of the rod, of the string where the gauge is, or of "
        "another "
        "bar; a voltage by a calibration, or by gain, excitation and bridge factor; a velocity by the "
        "impedance. Tension is positive in the rod; a blow presses.\n"
        "Zero line: the mean of the first samples, in which nothing happens.\n"
        "Range: “Peak” takes the stretch around the largest value, “View” what the plot shows (Ctrl+wheel "
        "and "
        "Shift+drag zoom there), “All” the whole record.\n"
        "Points at most: a blow keeps as few samples as leave impulse and e the same to 1e-4, unless you "
        "choose a number; a curve keeps so many. The summary says how far the others are from the lines "
        "between them.");
}

}  // namespace drillwave
