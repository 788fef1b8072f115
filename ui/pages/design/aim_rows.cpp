// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/aim_rows.h"

#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "core/report/design_words.h"
#include "ui/form/choice_box.h"
#include "ui/pages/study/flow_layout.h"
#include "ui/pages/study/output_box.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr std::array offeredStatistics{"mean", "q01", "q05", "q10", "q25",    "q50",
                                       "q75",  "q90", "q95", "q99", "nominal"};

Statistic statisticNamed(const char* name) {
    return *findStatistic(name);
}

}  // namespace

AimRow::AimRow(const QString& words, QWidget* parent)
    : QWidget(parent),
      m_sense(new ChoiceBox(this)),
      m_output(new OutputBox(this, OfferedOutputs::ofOneBlow)),
      m_statistic(new ChoiceBox(this)),
      m_remove(new QToolButton(this)) {
    m_sense->setObjectName(QStringLiteral("sense"));
    m_sense->setAccessibleName(tr("Maximise or minimise"));
    m_sense->setMinimumContentsLength(6);
    m_sense->addItem(tr("largest"));
    m_sense->addItem(tr("smallest"));
    m_statistic->setObjectName(QStringLiteral("statistic"));
    m_statistic->setAccessibleName(tr("Statistic"));
    for (const char* name : offeredStatistics) m_statistic->addItem(QString(), QString::fromLatin1(name));
    m_remove->setObjectName(QStringLiteral("remove"));
    m_remove->setText(QStringLiteral("✕"));
    m_remove->setAutoRaise(true);
    m_remove->setAccessibleName(tr("Remove this aim"));
    auto* label = new QLabel(words, this);
    label->setBuddy(m_sense);
    auto* layout = new FlowLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    for (QWidget* each : std::initializer_list<QWidget*>{label, m_sense, m_output, m_statistic, m_remove})
        layout->addWidget(each);
    nameStatistics();
    for (ChoiceBox* box : std::initializer_list<ChoiceBox*>{m_sense, m_output, m_statistic})
        box->followText();
    connect(m_sense, &QComboBox::currentIndexChanged, this, [this] {
        nameStatistics();
        emit changed();
    });
    connect(m_output, &OutputBox::changed, this, &AimRow::changed);
    connect(m_statistic, &QComboBox::currentIndexChanged, this, &AimRow::changed);
    connect(m_remove, &QToolButton::clicked, this, &AimRow::removed);
}

// The name of the worst end depends on the sense.
void AimRow::nameStatistics() {
    const Sense sense = m_sense->currentIndex() == 0 ? Sense::largest : Sense::least;
    for (int i = 0; i < m_statistic->count(); ++i)
        m_statistic->setItemText(
            i, translated(statisticMessage(statisticNamed(offeredStatistics[std::size_t(i)]), sense)));
    m_statistic->updateGeometry();
}

void AimRow::present(const Scenario& scenario) {
    m_output->present(scenario);
}

DesignAim AimRow::aim() const {
    return {m_sense->currentIndex() == 0 ? Sense::largest : Sense::least, &m_output->output(),
            statisticNamed(offeredStatistics[std::size_t(std::max(0, m_statistic->currentIndex()))])};
}

void AimRow::setAim(const DesignAim& aim) {
    {
        const QSignalBlocker quiet(this);
        m_sense->setCurrentIndex(aim.sense == Sense::largest ? 0 : 1);
        m_output->setOutput(*aim.output);
        m_statistic->setCurrentIndex(
            std::max(0, m_statistic->findData(QString::fromStdString(aim.statistic.name()))));
    }
    emit changed();
}

void AimRow::setRemovable(bool removable) {
    m_remove->setVisible(removable);
}

AimRows::AimRows(QWidget* parent)
    : QWidget(parent),
      m_layout(new QVBoxLayout(this)),
      m_add(new QToolButton(this)),
      m_rows(*m_layout, *m_add, 1, mostAims) {
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(2);
    m_add->setObjectName(QStringLiteral("addAim"));
    m_add->setText(tr("+ aim"));
    m_add->setToolTip(tr("Adds an objective. The first one decides; the others show the trade-off."));
    m_layout->addWidget(m_add);
    connect(m_add, &QToolButton::clicked, this, [this] {
        m_isChosen = true;
        append({Sense::largest, findOutput("loading_work"), statisticNamed("q05")});
        emit changed();
    });
}

void AimRows::present(const Scenario& scenario) {
    m_scenario = scenario;
    const std::vector<DesignAim> before = aims();
    const bool canStay = m_isChosen && std::ranges::all_of(before, [&](const DesignAim& aim) {
                             return aim.output->problem(scenario).isEmpty();
                         });
    const std::vector<DesignAim> wanted = canStay ? before : customaryAims(scenario);
    const QSignalBlocker quiet(this);
    if (wanted == before)
        for (AimRow* row : rows()) row->present(scenario);
    else
        setAims(wanted);
    m_isChosen = canStay;
}

std::vector<DesignAim> AimRows::aims() const {
    std::vector<DesignAim> aims;
    for (const AimRow* row : rows()) aims.push_back(row->aim());
    return aims;
}

void AimRows::setAims(const std::vector<DesignAim>& aims) {
    {
        const QSignalBlocker quiet(this);
        m_rows.clear();
        for (const DesignAim& aim : aims) append(aim);
        m_isChosen = true;
    }
    emit changed();
}

void AimRows::append(const DesignAim& aim) {
    auto* row = new AimRow(rows().empty() ? tr("for the") : tr("then the"), this);
    row->present(m_scenario);
    row->setAim(aim);
    const auto choose = [this] {
        m_isChosen = true;
        emit changed();
    };
    connect(row, &AimRow::changed, this, choose);
    m_rows.append(row, choose);
}

}  // namespace drillwave
