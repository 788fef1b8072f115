// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/result_row.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyleOptionFocusRect>
#include <QStylePainter>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/blow/feed_estimate.h"
#include "core/model/scales.h"
#include "ui/form/section_box.h"
#include "ui/job/output_text.h"
#include "ui/result/feed_text.h"
#include "ui/runs/difference_text.h"
#include "ui/text/lightness.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {

namespace {

// Sets a larger, bold font, for values that are read first.
void makeHeavy(QLabel& label) {
    QFont font = label.font();
    font.setPointSizeF(font.pointSizeF() * 1.15);
    font.setBold(true);
    label.setFont(font);
}

ResultEntry::Number numberOf(const Output& output) {
    if (output.measure == Measure::error) return nullptr;
    return
        [&output](const SolvedBlow& blow, UnitSystem units) { return comparableNumber(output, blow, units); };
}

ResultEntry::Text textOf(const Output& output) {
    switch (output.measure) {
        case Measure::impulse:
            return [&output](const SolvedBlow& blow) { return impulseText(output, blow); };
        default:
            return [&output](const SolvedBlow& blow) { return outputText(output, blow); };
    }
}

}  // namespace

PlaceLink::PlaceLink(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setForegroundRole(QPalette::Link);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    QFont underlined = font();
    underlined.setUnderline(true);
    setFont(underlined);
}

void PlaceLink::keyPressEvent(QKeyEvent* event) {
    const int key = event->key();
    if (key != Qt::Key_Return && key != Qt::Key_Enter && key != Qt::Key_Space)
        return QLabel::keyPressEvent(event);
    emit followed();
}

// Taken, so that the release comes here too.
void PlaceLink::mousePressEvent(QMouseEvent* event) {
    event->setAccepted(event->button() == Qt::LeftButton);
}

void PlaceLink::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && rect().contains(event->position().toPoint())) emit followed();
}

void PlaceLink::paintEvent(QPaintEvent* event) {
    QLabel::paintEvent(event);
    if (!hasFocus()) return;
    QStylePainter painter(this);
    QStyleOptionFocusRect focus;
    focus.initFrom(this);
    painter.drawPrimitive(QStyle::PE_FrameFocusRect, focus);
}

void makeSelectable(QLabel& label) {
    label.setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label.setContextMenuPolicy(Qt::NoContextMenu);
}

ResultRow::ResultRow(ResultEntry entry, SectionBox* section, QGridLayout* grid)
    : m_entry(std::move(entry)),
      m_section(section),
      m_name(new QLabel(m_entry.name, section->content())),
      m_value(m_entry.place ? new PlaceLink(section->content()) : new QLabel(section->content())),
      m_change(new QLabel(section->content())) {
    m_change->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_change->hide();
    m_name->setToolTip(m_entry.meaning);
    m_name->setBuddy(m_value);
    m_value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_value->setObjectName(m_entry.objectName);
    if (!m_entry.place) makeSelectable(*m_value);
    place(grid);
}

void ResultRow::place(QGridLayout* grid) {
    const int row = grid->rowCount();
    if (m_entry.name.isEmpty()) {
        m_name->hide();
        grid->addWidget(m_value, row, 1, 1, 3);
    } else if (m_entry.weight == ResultEntry::Weight::heavy) {
        makeHeavy(*m_value);
        auto* line = new QHBoxLayout;
        line->addWidget(m_name);
        line->addStretch();
        line->addWidget(m_change);
        line->addSpacing(grid->horizontalSpacing());
        line->addWidget(m_value);
        grid->addLayout(line, row, 1, 1, 3);
    } else {
        if (m_entry.part)
            grid->addWidget(m_swatch = new EnergySwatch(*m_entry.part, m_section->content()), row, 0);
        grid->addWidget(m_name, row, 1);
        grid->addWidget(m_change, row, 2);
        grid->addWidget(m_value, row, 3);
    }
}

bool ResultRow::isFilled() const {
    return isThere() && m_value->text() != noNumber;
}

QString ResultRow::text() const {
    const QString change = m_change->text();
    return m_section->title() + QStringLiteral(": ") + m_name->text() + QLatin1Char('\t') + m_value->text() +
           (change.isEmpty() ? QString() : QLatin1Char('\t') + change);
}

void ResultRow::offer(const Scenario& scenario) const {
    if (!m_entry.concerns) return;
    const bool offered = m_entry.concerns(scenario);
    m_name->setVisible(offered && !m_entry.name.isEmpty());
    m_value->setVisible(offered);
    if (m_swatch) m_swatch->setVisible(offered);
}

void ResultRow::present(const SolvedBlow& blow) const {
    const bool solved = blow.fault.isEmpty();
    const QString text = solved ? m_entry.text(blow) : QString();
    m_value->setText(text.isEmpty() ? noNumber : text);
    if (m_entry.warning) setWarning(*m_value, solved && m_entry.warning(blow));
    const QString note = solved && m_entry.note ? m_entry.note(blow) : QString();
    m_value->setToolTip(note.isEmpty() ? m_entry.meaning : m_entry.meaning + QStringLiteral(".\n") + note);
    // A value without a name belongs to the row above.
    m_value->setAccessibleName(m_entry.name.isEmpty()
                                   ? m_value->text()
                                   : QStringLiteral("%1: %2").arg(m_entry.name, m_value->text()));
}

QString ResultRow::changeText(const SolvedBlow& blow, const SolvedBlow* reference) const {
    const UnitSystem units = blow.request.units;
    if (!reference || !m_entry.number || !isThere() || !blow.fault.isEmpty()) return {};
    if (m_entry.concerns && !m_entry.concerns(reference->scenario)) return {};
    if (m_entry.output && !haveSameUnit(*m_entry.output, blow, *reference, units)) return {};
    const std::optional<double> now = m_entry.number(blow, units);
    const std::optional<double> then = m_entry.number(*reference, units);
    if (!now || !then) return {};
    return m_entry.change ? m_entry.change(*now, *then, blow) : relativeText(*now, *then);
}

void ResultRow::presentChange(const SolvedBlow& blow, const SolvedBlow* reference,
                              const QString& title) const {
    const QString change = changeText(blow, reference);
    m_change->setText(change);
    m_change->setVisible(!change.isEmpty());
    if (change.isEmpty()) return;
    m_change->setToolTip(withoutMarkup(drillwave::tr("Difference from %1").arg(title)));
    m_change->setAccessibleName(drillwave::tr("%1, against %2: %3").arg(m_entry.name, title, change));
}

QList<ResultEntry> outputEntries(OutputGroup group) {
    std::vector<const Output*> wanted;
    for (const Output& output : outputs())
        if (output.group == group) wanted.push_back(&output);
    std::ranges::stable_sort(wanted, {}, &Output::order);
    QList<ResultEntry> entries;
    for (const Output* const each : wanted) {
        const Output& output = *each;
        const auto concerns = [&output](const Scenario& scenario) { return output.concerns(scenario); };
        entries.append({.name = coreText(output.label()),
                        .meaning = coreText(output.note),
                        .text = textOf(output),
                        .part = output.part,
                        .number = numberOf(output),
                        .concerns = concerns,
                        .output = &output});
        if (!output.load) continue;
        entries.append(
            {.meaning = tr("Place and time where this value is first reached: a click leads there"),
             .text = [&output](const SolvedBlow& blow) { return placeText(output, blow); },
             .place = &output,
             .concerns = concerns});
    }
    return entries;
}

QList<ResultEntry> thrustEntries(const WorstNeed& worst, const ResultEntry::Number& worstOf) {
    const auto hasPeriod = [](const Scenario& scenario) { return gapPeriod(scenario).has_value(); };
    return {
        {.name = tr("margin, this blow"),
         .meaning =
             tr("Effective feed force minus the feed force required by this blow, also as a share of it"),
         .text = thrustMarginText,
         .number = [](const SolvedBlow& blow, UnitSystem) { return thrustMargin(blow); },
         .change = marginChangeText},
        {.name = tr("required, this blow"),
         .meaning = tr("Mean force that balances this blow, which starts at rest on the rock"),
         .text = thrustNeededText,
         .number =
             [](const SolvedBlow& blow, UnitSystem) {
                 return thrustNeeded(blow.scenario, blow.summary.cor, blow.summary.transferred);
             }},
        {.name = tr("return in time"),
         .meaning = tr("At this feed an undamped rigid rod is back at the rock before the next blow"),
         .text = returnInTimeText,
         .number =
             [](const SolvedBlow& blow, UnitSystem) {
                 return thrustNeeded(blow.scenario, 2 * blow.summary.cor, blow.summary.transferred);
             }},
        {.name = tr("required, every gap"),
         .meaning =
             tr("The largest force required by this blow, by 95 % of all gaps, on rigid rock, and by the "
                "worst gap on elastic rock"),
         .text = [&worst](const SolvedBlow& blow) { return worstNeedText(worst, blow); },
         .note = [&worst](const SolvedBlow&) { return worst.problem(); },
         .objectName = worstName,
         .number = worstOf,
         .concerns = hasPeriod},
        {.meaning = tr("Effective feed force minus the largest of the four, also as a share of it: "
                       "thrust_margin in commands and files"),
         .text = [&worst](const SolvedBlow& blow) { return worstMarginText(worst, blow); },
         .objectName = worstName,
         .warning = [&worst](const SolvedBlow& blow) { return isShortOfWorst(worst, blow); },
         .concerns = hasPeriod},
        {.name = tr("installed"),
         .meaning = tr("Feed force of the drill rig"),
         .text = thrustInstalledText,
         .number = [](const SolvedBlow& blow, UnitSystem) { return blow.scenario.drill.thrust; }},
    };
}

ResultEntry hammerEnergyEntry() {
    return {.name = tr("hammer energy E₀"),
            .meaning = tr("Energy of the hammer before the blow; all shares refer to it. Its work on the "
                          "string is smaller."),
            .text = hammerEnergyText,
            .number = [](const SolvedBlow& blow, UnitSystem) { return blow.scales.energy; },
            .concerns = [](const Scenario& scenario) { return concerns(OutputOf::hammer, scenario); }};
}

ResultEntry corEntry() {
    return {.name = tr("COR e"),
            .meaning = tr("Coefficient of restitution: momentum after the blow over momentum before it, "
                          "reversed, e = −pf/p0"),
            .text = [](const SolvedBlow& blow) { return numberText(blow.summary.cor, 4, QLocale()); },
            .note = corErrorText,
            .weight = ResultEntry::Weight::heavy,
            .objectName = QStringLiteral("cor"),
            .number = numberOf(*findOutput("cor"))};
}

}  // namespace drillwave
