#include "ui/pages/blow_page.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace drillwave {

BlowPage::BlowPage(Observation& observation, QWidget* parent)
    : Page(parent),
      m_observation(observation),
      m_hint(new QLabel(this)),
      m_section(new QDoubleSpinBox(this)),
      m_plot(new PlotWidget(this)),
      m_plots(new BlowPlots(m_plot)) {
    m_section->setObjectName(QStringLiteral("section"));
    m_section->setRange(0, 1);
    m_section->setDecimals(2);
    m_section->setSingleStep(0.05);
    m_section->setValue(observation.section());
    m_section->setAccessibleName(tr("Section x/L of the waves"));
    m_section->setToolTip(tr("Where in the rod the waves are observed: 0 is the struck end, 1 the bit"));
    auto* label = new QLabel(tr("Section x/L"), this);
    label->setBuddy(m_section);
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    // Asks for no width: it is there when there is room.
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_hint->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* fitButton = new QPushButton(tr("Fit"), this);
    fitButton->setToolTip(tr("Bring all curves into view (double-click in the plots)"));

    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(8, 6, 8, 0);
    bar->addWidget(label);
    bar->addWidget(m_section);
    bar->addWidget(m_hint, 1);
    bar->addWidget(fitButton);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(bar);
    layout->addWidget(m_plot, 1);

    m_plot->setAccessibleName(tr("Waves, impact force, impulse and momentum over time"));
    m_plot->followPalette([this](const PlotStyle& style) { m_plots->setStyle(style); });
    connect(m_section, &QDoubleSpinBox::valueChanged, &observation, &Observation::setSection);
    connect(&observation, &Observation::sectionChanged, this, &BlowPage::showSection);
    connect(m_plot, &PlotWidget::fitRequested, this, &BlowPage::fit);
    connect(fitButton, &QPushButton::clicked, this, &BlowPage::fit);
}

void BlowPage::addNeeds(SolveRequest& request) const {
    request.section = m_observation.section();
}

// Shown with two decimals, kept with all.
void BlowPage::showSection(double section) {
    const QSignalBlocker quiet(m_section);
    m_section->setValue(section);
    emit needsChanged();
}

void BlowPage::setResult(const SolvedBlowPtr& blow) {
    if (blow->curves)
        m_plots->show(*blow->curves);
    else if (!blow->problem.isEmpty())
        m_plots->showNothing(tr("Nothing to show: %1").arg(blow->problem));
    m_plot->setAccessibleDescription(m_plots->textSummary());
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void BlowPage::resizeEvent(QResizeEvent* event) {
    Page::resizeEvent(event);
    m_hint->setText(width() > 560 ? tr("wheel zooms · drag moves · double-click fits") : QString());
}

void BlowPage::fit() {
    m_plots->fit();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace drillwave
