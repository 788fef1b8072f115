// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/result_row.h"

#include <QGridLayout>
#include <utility>

#include "ui/form/section_box.h"
#include "ui/result/output_unit.h"
#include "ui/result/place_link.h"
#include "ui/runs/difference_text.h"
#include "ui/text/lightness.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

// Of the values that are read first.
void makeHeavy(QLabel& label) {
    QFont font = label.font();
    font.setPointSizeF(font.pointSizeF() * 1.15);
    font.setBold(true);
    label.setFont(font);
}

}  // namespace

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
    // What has no name of its own goes on from the row above.
    m_value->setAccessibleName(m_entry.name.isEmpty()
                                   ? m_value->text()
                                   : QStringLiteral("%1: %2").arg(m_entry.name, m_value->text()));
}

QString ResultRow::changeText(const SolvedBlow& blow, const SolvedBlow* reference) const {
    const UnitSystem units = blow.request.units;
    if (!reference || !m_entry.number || !isThere() || !blow.fault.isEmpty()) return {};
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
    m_change->setToolTip(withoutMarkup(drillwave::tr("Off %1 by so much").arg(title)));
    m_change->setAccessibleName(drillwave::tr("%1, against %2: %3").arg(m_entry.name, title, change));
}

}  // namespace drillwave
