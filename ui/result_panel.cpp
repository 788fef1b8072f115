#include "ui/result_panel.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QScrollBar>
#include <QSet>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/number_text.h"

namespace drillwave {
namespace {

constexpr int visibleEvents = 7;

QString percent(double fraction) {
    return numberText(100 * fraction, 4, QLocale()) + QChar(QChar::Nbsp) + QLatin1Char('%');
}

QString newtons(double force) {
    return quantityText(force, ShownUnit{1e-3, QStringLiteral("kN"), false}, QLocale());
}

QString shown(double value, const ShownUnit& unit) {
    return quantityText(value, unit, QLocale());
}

QString workText(const SolvedBlow& blow) {
    if (blow.request.units == UnitSystem::dimensionless)
        return numberText(blow.summary.workRatio, 4, QLocale()) + QStringLiteral(" W₀");
    return quantityText(blow.summary.workRatio * blow.scales.energy, ShownUnit{1, QStringLiteral("J"), false},
                        QLocale());
}

QString marginText(const SolvedBlow& blow) {
    const std::optional<double>& installed = blow.request.scenario.drill.thrust;
    return blow.thrust && installed ? newtons(*installed - *blow.thrust) : QString();
}

}  // namespace

ResultPanel::ResultPanel(QWidget* parent) : QScrollArea(parent), m_eventModel(new EventModel(this)) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidget(new QWidget);
    auto* layout = new QVBoxLayout(widget());
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(8);
    widget()->setMinimumWidth(215);
    addHeadline();
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
    addNumbers(tr("Energy"),
               {{tr("hammer work W"), tr("Work of the hammer on the rod"), workText},
                {tr("into the rock"), tr("Share of the hammer work that stays in the rock: the efficiency"),
                 [](const SolvedBlow& b) { return percent(b.summary.energy.rockWork); }},
                {tr("into the rebound"), tr("Share of the hammer work that moves the rod back as a whole"),
                 [](const SolvedBlow& b) { return percent(b.summary.energy.reboundEnergy); }},
                {tr("left in waves"), tr("Share of the hammer work that runs to and fro in the rod"),
                 [](const SolvedBlow& b) { return percent(b.summary.energy.residualWaveEnergy); }},
                {tr("balance error"), tr("What the three shares miss of the hammer work"),
                 [](const SolvedBlow& b) { return magnitudeText(b.summary.energy.residual, QLocale()); }}});
    addNumbers(tr("Thrust"),
               {{tr("needed"), tr("Mean thrust that returns the rod to the rock between blows: f·I₀·(1 + e)"),
                 [](const SolvedBlow& b) { return b.thrust ? newtons(*b.thrust) : QString(); }},
                {tr("installed"), tr("Feed force of the drill rig"),
                 [](const SolvedBlow& b) {
                     const std::optional<double>& installed = b.request.scenario.drill.thrust;
                     return installed ? newtons(*installed) : QString();
                 }},
                {tr("margin"), tr("Installed less needed thrust; negative: the bit bounces off the rock"),
                 marginText}});
    m_alerts = new AlertList;
    auto* alertLayout = new QVBoxLayout(addSection(tr("Alerts"))->content());
    alertLayout->setContentsMargins(8, 0, 0, 0);
    alertLayout->addWidget(m_alerts);
    addEvents();
    layout->addStretch();
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
    for (QLabel* label : {m_cor, m_error})
        label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
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
    for (const Entry& entry : entries) {
        auto* name = new QLabel(entry.name, content);
        auto* value = new QLabel(content);
        name->setToolTip(entry.meaning);
        value->setToolTip(entry.meaning);
        value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        name->setBuddy(value);
        const int row = grid->rowCount();
        grid->addWidget(name, row, 0);
        grid->addWidget(value, row, 1);
        m_rows.append({section, name, value, entry.text});
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
    m_events->setTabKeyNavigation(false);
    const int header = m_events->horizontalHeader()->sizeHint().height();
    m_events->setMinimumHeight(header + visibleEvents * m_events->verticalHeader()->defaultSectionSize());
    layout->addWidget(m_events);
    connect(m_events->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& index) {
                if (index.isValid()) emit timeChosen(m_eventModel->timeAt(index.row()));
            });
}

void ResultPanel::show(const SolvedBlowPtr& blow) {
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
        row.value->setAccessibleName(QStringLiteral("%1: %2").arg(row.name->text(), row.value->text()));
    }
    // Without frequency and feed force there is nothing to say about the thrust.
    for (const Row& row : std::as_const(m_rows))
        row.section->setVisible(!solved || filled.contains(row.section));
    m_alerts->show(blow->problem, blow->alerts);
    m_eventModel->show(blow);
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
