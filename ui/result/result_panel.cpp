// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/result_panel.h"

#include <QAction>
#include <QClipboard>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QSet>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr int visibleEvents = 7;

// Shares of the energy are known to 1e-12: what is smaller is rounding.
QString percent(double fraction) {
    return numberText(std::abs(fraction) < 1e-12 ? 0 : 100 * fraction, 4, QLocale()) + QChar(QChar::Nbsp) +
           QLatin1Char('%');
}

QString newtons(double force) {
    return quantityText(force, ShownUnit{1e-3, QStringLiteral("kN"), false}, QLocale());
}

QString shown(double value, const ShownUnit& unit) {
    return quantityText(value, unit, QLocale());
}

// Its text can be selected; the menu is that of the panel.
void makeSelectable(QLabel& label) {
    label.setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label.setContextMenuPolicy(Qt::NoContextMenu);
}

QString workText(const SolvedBlow& blow) {
    if (blow.request.units == UnitSystem::dimensionless)
        return numberText(blow.summary.workRatio, 4, QLocale()) + QStringLiteral(" W₀");
    return quantityText(blow.summary.workRatio * blow.scales.energy, ShownUnit{1, QStringLiteral("J"), false},
                        QLocale());
}

QString stressText(const SolvedBlow& blow, double force) {
    if (blow.request.units == UnitSystem::dimensionless) return shown(force, blow.units.force);
    return quantityText(force * blow.scales.stress, ShownUnit{1e-6, QStringLiteral("MPa"), false}, QLocale());
}

// Where in the rod, and when: below the stress, in a line of its own.
QString placeText(const SolvedBlow& blow, const RodForce& force) {
    if (!(force.size > 0)) return {};
    const QString time = shown(force.time, blow.units.time);
    if (blow.request.units == UnitSystem::dimensionless)
        return ResultPanel::tr("at x/L = %1, t = %2").arg(numberText(force.section, 3, QLocale()), time);
    const ShownUnit metres{1, QStringLiteral("m"), false};
    return ResultPanel::tr("%1 from the hammer, t = %2")
        .arg(quantityText(force.section * blow.request.scenario.rod.length, metres, QLocale()), time);
}

// The bracket of what this blow needs: full penetration, to the bit back in time without a damper.
QString neededText(const SolvedBlow& blow) {
    if (!blow.feed) return {};
    return ResultPanel::tr("%1 … %2").arg(numberText(blow.feed->fullRate / 1000, 4, QLocale()),
                                          newtons(blow.feed->returned));
}

QString marginText(const SolvedBlow& blow) {
    if (!blow.feed || !blow.feed->installed) return {};
    const double margin = *blow.feed->installed - blow.feed->fullRate;
    const QString share = numberText(std::round(100 * margin / blow.feed->fullRate), 4, QLocale());
    return newtons(margin) + QStringLiteral(" (%1%2 %)").arg(margin > 0 ? "+" : "", share);
}

QString feedText(const SolvedBlow& blow) {
    if (!blow.feed) return {};
    const std::string_view word = feedWord(blow.feed->feed);
    return fromView(word);
}

QString feedMeaning(const SolvedBlow& blow) {
    return blow.feed ? QString::fromStdString(feedSentence(*blow.feed)) : QString();
}

}  // namespace

ResultPanel::ResultPanel(QWidget* parent)
    : QScrollArea(parent), m_eventModel(new EventModel(this)), m_veil(new StaleVeil(viewport())) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidget(new QWidget);
    auto* layout = new QVBoxLayout(widget());
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(8);
    addHeadline();
    addImpact();
    addEnergy();
    addStress();
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

void ResultPanel::addImpact() {
    addNumbers(
        tr("Impact"),
        {{tr("impulse 1 + e"), tr("Impulse of the impact force on the rock"),
          [](const SolvedBlow& b) { return shown(b.summary.impulse, b.units.impulse); }},
         {tr("peak force"), tr("Largest impact force"),
          [](const SolvedBlow& b) { return shown(b.summary.peakForce, b.units.force); }},
         {tr("penetration"), tr("Largest penetration of the bit during the blow"),
          [](const SolvedBlow& b) { return shown(b.summary.maxPenetration, b.units.penetration); }},
         {tr("… that stays"), tr("Penetration that stays after the blow"),
          [](const SolvedBlow& b) { return shown(b.summary.residualPenetration, b.units.penetration); }},
         {tr("first contact"), tr("Time of the first contact"),
          [](const SolvedBlow& b) { return shown(b.summary.firstContactTime, b.units.time); }},
         {tr("last separation"), tr("Time of the last separation"),
          [](const SolvedBlow& b) { return shown(b.summary.separationTime, b.units.time); }},
         {tr("time in contact"), tr("Summed over all contacts"),
          [](const SolvedBlow& b) { return shown(b.summary.contactDuration, b.units.time); }}});
}

void ResultPanel::addEnergy() {
    addNumbers(
        tr("Energy"),
        {{tr("hammer work W"), tr("Work of the hammer on the rod"), workText},
         {tr("into the rock"), tr("Share of the hammer work that stays in the rock: the efficiency"),
          [](const SolvedBlow& b) { return percent(b.summary.energy.rockWork); }, EnergyPart::rock},
         {tr("into the rebound"), tr("Share of the hammer work that moves the rod back as a whole"),
          [](const SolvedBlow& b) { return percent(b.summary.energy.reboundEnergy); }, EnergyPart::rebound},
         {tr("left in waves"), tr("Share of the hammer work that runs to and fro in the rod"),
          [](const SolvedBlow& b) { return percent(b.summary.energy.residualWaveEnergy); },
          EnergyPart::waves},
         {tr("balance error"), tr("What the three shares miss of the hammer work"),
          [](const SolvedBlow& b) { return magnitudeText(b.summary.energy.residual, QLocale()); }}});
    m_energy = new EnergyBar(widget());
    QGridLayout* grid = m_grids.last();
    grid->addWidget(m_energy, grid->rowCount(), 0, 1, 3);
}

void ResultPanel::addStress() {
    const QString where = tr("Where in the rod it is first that large, and when");
    const QString during = tr(
        "Largest %1 stress of the uniform rod while the blow lasts: to the last separation plus one transit "
        "time; couplings and threads raise it locally");
    const QString after = tr(
        "Largest %1 stress of the waves that are left after the blow and run on; nothing damps them in the "
        "model, a real rod does");
    addNumbers(
        tr("Stress in the rod"),
        {{tr("compression, blow"), during.arg(tr("compressive")),
          [](const SolvedBlow& b) { return stressText(b, b.summary.rodForces->compression.size); }},
         {{}, where, [](const SolvedBlow& b) { return placeText(b, b.summary.rodForces->compression); }},
         {tr("tension, blow"), during.arg(tr("tensile")),
          [](const SolvedBlow& b) { return stressText(b, b.summary.rodForces->tension.size); }},
         {{}, where, [](const SolvedBlow& b) { return placeText(b, b.summary.rodForces->tension); }},
         {tr("compression, after"), after.arg(tr("compressive")),
          [](const SolvedBlow& b) { return stressText(b, b.summary.rodForces->compressionAfter.size); }},
         {{}, where, [](const SolvedBlow& b) { return placeText(b, b.summary.rodForces->compressionAfter); }},
         {tr("tension, after"), after.arg(tr("tensile")),
          [](const SolvedBlow& b) { return stressText(b, b.summary.rodForces->tensionAfter.size); }},
         {{}, where, [](const SolvedBlow& b) { return placeText(b, b.summary.rodForces->tensionAfter); }}});
}

void ResultPanel::addThrust() {
    addNumbers(
        tr("Thrust"),
        {{tr("needed"),
          tr("Thrust for full penetration, f·I₀·(1 + e), up to that which brings the bit back before the "
             "next "
             "blow even if nothing damps, f·I₀·(1 + 2e), with the e of this blow"),
          neededText},
         {tr("installed"), tr("Feed force of the drill rig"),
          [](const SolvedBlow& b) {
              const std::optional<double>& installed = b.request.scenario.drill.thrust;
              return installed ? newtons(*installed) : QString();
          }},
         {tr("margin"),
          tr("Installed thrust less f·I₀·(1 + e) of this blow, and as a share of it; `drillwave thrust` adds "
             "the margins of other gaps and rocks"),
          marginText},
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
    m_events = new QTableView(widget());
    m_events->setAccessibleName(tr("Events at the bit"));
    m_events->setModel(m_eventModel);
    m_events->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_events->setShowGrid(false);
    m_events->setAlternatingRowColors(true);
    m_events->verticalHeader()->hide();
    m_events->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    m_events->horizontalHeader()->setStretchLastSection(true);
    m_events->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_events->horizontalHeader()->setResizeContentsPrecision(visibleEvents);  // not of thousands of rows
    m_events->setContextMenuPolicy(Qt::NoContextMenu);
    m_events->setSelectionMode(QAbstractItemView::SingleSelection);
    m_events->setToolTip(tr("Choose an event to move the time cursor there"));
    m_events->setTabKeyNavigation(false);
    const int header = m_events->horizontalHeader()->sizeHint().height();
    m_events->setMinimumHeight(header + visibleEvents * m_events->verticalHeader()->defaultSectionSize());
    layout->addWidget(m_events);
    const auto choose = [this](const QModelIndex& index) {
        if (index.isValid() && !m_following) emit timeChosen(m_eventModel->timeAt(index.row()));
    };
    connect(m_events->selectionModel(), &QItemSelectionModel::currentRowChanged, this, choose);
    // The row that is current already can be chosen again when the cursor has gone elsewhere.
    connect(m_events, &QTableView::clicked, this, choose);
    connect(m_events, &QTableView::activated, this, choose);
}

// One set of columns through all sections, wide enough for every number: a panel whose width follows the
// values would jump while they are dragged.
void ResultPanel::alignColumns() {
    const QString widest = QStringLiteral("−8888.8 kN (+8888 %)");
    const int value = fontMetrics().horizontalAdvance(widest);
    for (QGridLayout* grid : std::as_const(m_grids)) grid->setColumnMinimumWidth(2, value);
}

void ResultPanel::setTime(std::optional<double> time) {
    m_time = time;
    markEvent();
}

void ResultPanel::markEvent() {
    const QScopedValueRollback following(m_following, true);
    const QModelIndex current = m_events->currentIndex();
    const bool isThere = m_time && current.isValid() && m_eventModel->timeAt(current.row()) == *m_time;
    const std::optional<int> row = isThere  ? current.row()
                                   : m_time ? m_eventModel->rowAt(*m_time)
                                            : std::nullopt;
    if (!row) {
        m_events->clearSelection();
        return;
    }
    m_events->selectRow(*row);
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
    m_eventModel->present(blow);
    markEvent();
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
