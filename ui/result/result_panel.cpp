// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/result_panel.h"

#include <QAction>
#include <QClipboard>
#include <QGridLayout>
#include <QGuiApplication>
#include <QScrollBar>
#include <QSet>
#include <QVBoxLayout>
#include <algorithm>
#include <string>

#include "ui/result/event_table.h"
#include "ui/result/feed_text.h"
#include "ui/result/output_text.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

// Its text can be selected; the menu is that of the panel.
void makeSelectable(QLabel& label) {
    label.setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label.setContextMenuPolicy(Qt::NoContextMenu);
}

// Its swatch in the bar of the energy.
std::optional<EnergyPart> partOf(const Output& output) {
    if (output.name == "rock_work") return EnergyPart::rock;
    if (output.name == "rebound_energy") return EnergyPart::rebound;
    if (output.name == "residual_wave_energy") return EnergyPart::waves;
    return std::nullopt;
}

QString words(std::string_view text) {
    return ResultPanel::tr(std::string(text).c_str());
}

}  // namespace

ResultPanel::ResultPanel(QWidget* parent) : QScrollArea(parent), m_veil(new StaleVeil(viewport())) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidget(new QWidget);
    auto* layout = new QVBoxLayout(widget());
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(8);
    addHeadline();
    addOutputs(tr("Impact"), OutputGroup::impact);
    addEnergy();
    addOutputs(tr("Stress in the rod"), OutputGroup::stress);
    addThrust();
    addAlerts();
    addEvents();
    alignColumns();
    layout->addStretch();
    auto* copyAll = new QAction(tr("&Copy results"), this);
    copyAll->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R));
    copyAll->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(copyAll, &QAction::triggered, this, &ResultPanel::copy);
    addAction(copyAll);
    setContextMenuPolicy(Qt::ActionsContextMenu);
}

void ResultPanel::addOutputs(const QString& title, OutputGroup group) {
    QList<Entry> entries;
    for (const Output& output : outputs()) {
        if (output.group != group) continue;
        entries.append({words(output.label), words(output.note),
                        [&output](const SolvedBlow& blow) { return outputText(output, blow); },
                        partOf(output)});
        if (output.force)
            entries.append({{},
                            tr("Where in the rod it is first that large, and when"),
                            [&output](const SolvedBlow& blow) { return placeText(output, blow); }});
    }
    addNumbers(title, entries);
}

void ResultPanel::addEnergy() {
    addOutputs(tr("Energy"), OutputGroup::energy);
    m_energy = new EnergyBar(widget());
    QGridLayout* grid = m_grids.last();
    grid->addWidget(m_energy, grid->rowCount(), 0, 1, 3);
}

void ResultPanel::addThrust() {
    addNumbers(
        tr("Thrust"),
        {{tr("needed"),
          tr("Thrust for full penetration, f·I₀·(1 + e), up to that which brings the bit back before the "
             "next "
             "blow even if nothing damps, f·I₀·(1 + 2e), with the e of this blow"),
          thrustNeededText},
         {tr("installed"), tr("Feed force of the drill rig"), thrustInstalledText},
         {tr("margin"),
          tr("Installed thrust less f·I₀·(1 + e) of this blow, and as a share of it; `drillwave thrust` adds "
             "the margins of other gaps and rocks"),
          thrustMarginText},
         {tr("feed"), tr("What the installed thrust does between the blows"), feedText, {}, feedMeaning}});
}

void ResultPanel::addAlerts() {
    m_alerts = new AlertList;
    auto* layout = new QVBoxLayout(addSection(tr("Alerts"))->content());
    layout->setContentsMargins(8, 0, 0, 0);
    layout->addWidget(m_alerts);
    connect(m_alerts, &AlertList::parameterChosen, this, &ResultPanel::parameterChosen);
}

SectionBox* ResultPanel::addSection(const QString& title) {
    auto* box = new SectionBox(title, widget());
    widget()->layout()->addWidget(box);
    return box;
}

void ResultPanel::addHeadline() {
    auto* title = new QLabel(tr("Coefficient of restitution e"), widget());
    m_cor = new QLabel(widget());
    m_error = new QLabel(widget());
    QFont large = m_cor->font();
    large.setPointSizeF(large.pointSizeF() * 1.9);
    large.setBold(true);
    m_cor->setFont(large);
    m_cor->setObjectName(QStringLiteral("cor"));
    m_cor->setToolTip(tr("Momentum after the blow over momentum before it, reversed: e = −pf/p0"));
    for (QLabel* label : {m_cor, m_error}) makeSelectable(*label);
    auto* line = new QHBoxLayout;
    line->addWidget(m_cor);
    line->addWidget(m_error, 1, Qt::AlignBottom);
    auto* layout = static_cast<QVBoxLayout*>(widget()->layout());
    layout->addWidget(title);
    layout->addLayout(line);
}

void ResultPanel::addNumbers(const QString& title, const QList<Entry>& entries) {
    SectionBox* section = addSection(title);
    QWidget* content = section->content();
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(8, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(1, 1);
    m_grids.append(grid);
    for (const Entry& entry : entries) {
        auto* name = new QLabel(entry.name, content);
        auto* value = new QLabel(content);
        name->setToolTip(entry.meaning);
        value->setToolTip(entry.meaning);
        value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        makeSelectable(*value);
        name->setBuddy(value);
        if (entry.name.isEmpty()) {
            name->setText({});
            name->hide();
            grid->addWidget(value, grid->rowCount(), 1, 1, 2);
            m_rows.append({section, name, value, entry.meaning, entry.text, entry.note});
            continue;
        }
        const int row = grid->rowCount();
        if (entry.part) grid->addWidget(new EnergySwatch(*entry.part, content), row, 0);
        grid->addWidget(name, row, 1);
        grid->addWidget(value, row, 2);
        m_rows.append({section, name, value, entry.meaning, entry.text, entry.note});
    }
}

void ResultPanel::addEvents() {
    auto* layout = new QVBoxLayout(addSection(tr("Events"))->content());
    layout->setContentsMargins(8, 0, 0, 0);
    m_events = new EventTable(widget());
    layout->addWidget(m_events);
    connect(m_events, &EventTable::timeChosen, this, &ResultPanel::timeChosen);
}

// One set of columns through all sections, wide enough for every number: a panel whose width follows the
// values would jump while they are dragged.
void ResultPanel::alignColumns() {
    const QString widest = QStringLiteral("−8888.8 kN (+8888 %)");
    const int value = fontMetrics().horizontalAdvance(widest);
    for (QGridLayout* grid : std::as_const(m_grids)) grid->setColumnMinimumWidth(2, value);
}

void ResultPanel::setTime(std::optional<double> time) {
    m_events->setTime(time);
}

void ResultPanel::setOutOfDate(bool outOfDate) {
    m_veil->raise();
    m_veil->setVisible(outOfDate);
}

QString ResultPanel::text() const {
    QString text = m_veil->isHidden() ? QString() : StaleVeil::words() + QLatin1Char('\n');
    text += tr("coefficient of restitution e") + QLatin1Char('\t') +
            QStringLiteral("%1 %2").arg(m_cor->text(), m_error->text()).trimmed() + QLatin1Char('\n');
    for (const Row& row : m_rows)
        if (!row.section->isHidden())
            text += row.section->title() + QStringLiteral(": ") + row.name->text() + QLatin1Char('\t') +
                    row.value->text() + QLatin1Char('\n');
    return text;
}

void ResultPanel::copy() const {
    QGuiApplication::clipboard()->setText(text());
}

void ResultPanel::present(const SolvedBlowPtr& blow) {
    const bool solved = blow->problem.isEmpty();
    const QString nothing = QStringLiteral("–");
    m_cor->setText(solved ? numberText(blow->summary.cor, 4, QLocale()) : nothing);
    m_cor->setAccessibleName(tr("Coefficient of restitution: %1").arg(m_cor->text()));
    m_error->setText(solved ? QStringLiteral("± ") + magnitudeText(blow->summary.corError, QLocale())
                            : QString());
    m_error->setAccessibleName(tr("Numerical error of the coefficient of restitution"));
    QSet<SectionBox*> filled;
    for (const Row& row : std::as_const(m_rows)) {
        const QString text = solved ? row.text(*blow) : QString();
        row.value->setText(text.isEmpty() ? nothing : text);
        if (!text.isEmpty()) filled.insert(row.section);
        const QString note = solved && row.note ? row.note(*blow) : QString();
        row.value->setToolTip(note.isEmpty() ? row.meaning : row.meaning + QStringLiteral(".\n") + note);
        row.value->setAccessibleName(QStringLiteral("%1: %2").arg(row.name->text(), row.value->text()));
    }
    // Without frequency and feed force there is nothing to say about the thrust.
    for (const Row& row : std::as_const(m_rows))
        row.section->setVisible(!solved || filled.contains(row.section));
    m_alerts->present(blow->problem, blow->alerts);
    if (solved)
        m_energy->present(blow->summary.energy);
    else
        m_energy->clear();
    m_events->present(blow);
}

QSize ResultPanel::sizeHint() const {
    const QSize content = widget()->sizeHint();
    return {content.width() + verticalScrollBar()->sizeHint().width() + 2, std::min(content.height(), 900)};
}

QSize ResultPanel::minimumSizeHint() const {
    return {std::max(widget()->minimumWidth(), widget()->minimumSizeHint().width()) +
                verticalScrollBar()->sizeHint().width() + 2,
            200};
}

}  // namespace drillwave
