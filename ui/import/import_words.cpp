// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_words.h"

#include <QLocale>
#include <cmath>

#include "core/text/handy_text.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"
#include "ui/text/translation.h"
#include "ui/text/unit_choice.h"

namespace drillwave {
namespace {

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

// Of the rod and the rock on show.
QString effectText(const ThinningEffect& effect) {
    const double change = std::abs(effect.change);
    const QString by = change > effect.error
                           ? tr("by %1").arg(numberText(change, 2, QLocale()))
                           : tr("by less than %1").arg(magnitudeText(effect.error, QLocale()));
    return tr("With the rod and the rock on show that changes e = %1 %2.")
        .arg(numberText(effect.cor, 4, QLocale()), by);
}

}  // namespace

QString importSummary(const ImportPreview& preview, const UnitChoice& units) {
    const ShapedSignal& signal = preview.signal;
    const double peak = std::abs(signal.peak);
    const double peakTime = signal.start + signal.peakTime - signal.points.front().time;
    QStringList parts;
    parts << tr("Impulse %1, peak %2 at %3 in the file.")
                 .arg(units.text(signal.impulse, UnitKind::impulse), units.text(signal.peak, UnitKind::force),
                      units.text(peakTime, UnitKind::time));
    if (signal.points.size() == signal.samples)
        parts << tr("All of the %1 samples are kept, of %2 in the record.")
                     .arg(countText(signal.samples), countText(preview.samples));
    else
        parts << tr("%1 of %2 samples become %3 points: no sample of what is taken is further than %4 (%5 of "
                    "the peak) from the lines between them, the impulse changes by %6.")
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
        parts << tr("That is much: take less of the record.");
    if (preview.skipped > 0)
        parts << tr("%1 rows without a number are skipped, the first is line %2.")
                     .arg(countText(preview.skipped), countText(preview.firstSkipped));
    if (preview.skipped > 0 && preview.skippedTime > 0)
        parts << tr("They leave a gap of %1, which a straight line crosses.")
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
