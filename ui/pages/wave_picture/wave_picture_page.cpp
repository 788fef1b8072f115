// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/wave_picture/wave_picture_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/pages/place_field.h"
#include "ui/pages/wave_picture/picture_cursors.h"
#include "ui/pages/wave_picture/play_bar.h"
#include "ui/pages/wave_picture/rod_profile.h"
#include "ui/pages/wave_picture/rod_strip.h"
#include "ui/pages/wave_picture/wave_picture_plot.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/runs.h"
#include "ui/text/settings.h"
#include "ui/text/unfocused_wheel.h"

namespace drillwave {
namespace {

const QString shownFieldKey = QStringLiteral("wavePicture/field");
const QString frontsKey = QStringLiteral("wavePicture/fronts");
const QString velocityName = QStringLiteral("velocity");

// Returns the runs that may be drawn: those whose waves can be read or are not solved yet.
RunList runsToDraw(const Scenario& scenario, const RunList& runs) {
    RunList drawn = runsLike(scenario, runs);
    std::erase_if(drawn, [](const Run& run) { return run.isSolved() && !run.blow->impact.hasHistories(); });
    return drawn;
}

}  // namespace

WavePicturePage::WavePicturePage(Observation& observation, QWidget* parent)
    : PlotPage(parent),
      m_observation(observation),
      m_field(new QComboBox(this)),
      m_fronts(new QCheckBox(tr("Fronts"), this)),
      m_section(new PlaceField(
          observation,
          tr("Section shown by the dashed line, also used on the page Blow: 0 is the struck end, 1 the bit."),
          this)),
      m_readout(new QLabel(this)),
      m_plot(makePlot()),
      m_picture(new WavePicturePlot(m_plot)),
      m_cursors(new PictureCursors(m_plot, m_picture)),
      m_profile(new RodProfile(this)),
      m_strip(new RodStrip(this)),
      m_playBar(new PlayBar(this)) {
    ignoreUnfocusedWheel(*m_field);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(makeAnswer());
    layout->addLayout(makeBar());
    layout->addWidget(m_readout);
    constexpr int profiles = 5;  // as high as the picture
    layout->addWidget(m_plot, profiles);
    constexpr int lines = 12;  // with its axis
    setLeastLines(lines);
    layout->addWidget(m_profile, 1);
    layout->addWidget(m_strip);
    layout->addWidget(m_playBar);
    useFrame(*m_picture, tr("Waves in the rod over position and time"));
    m_plot->followPalette([this](const PlotStyle& style) {
        m_picture->setStyle(style);
        m_cursors->setStyle(style);
    });
    m_plot->setDataText([this](char separator) { return m_picture->csv(separator); });
    m_plot->setNaming([this] { m_picture->name(); });
    restoreChoices();
    wire();
    m_cursors->setSection(observation.section());
}

QHBoxLayout* WavePicturePage::makeBar() {
    m_field->setObjectName(QStringLiteral("field"));
    m_field->addItem(tr("Force N"));
    m_field->addItem(tr("Particle velocity v"));
    m_field->setMinimumWidth(90);
    m_field->setAccessibleName(tr("Quantity shown by the colours"));
    m_field->setToolTip(
        tr("Normal force (tension positive) or particle velocity (towards the rock positive)"));
    m_fronts->setObjectName(QStringLiteral("fronts"));
    m_fronts->setToolTip(
        tr("Lines that start where the hammer force begins (solid), jumps or ends (dashed), and move at the "
           "wave speed"));
    auto* label = new QLabel(tr("Section x/L"), this);
    label->setBuddy(m_section);
    m_readout->setObjectName(QStringLiteral("readout"));
    m_readout->setAccessibleName(tr("Value at the pointer"));
    // Asks for no width, and keeps its row while it is empty: nothing jumps.
    m_readout->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_readout->setContentsMargins(8, 0, 8, 0);
    m_readout->setText(QStringLiteral(" "));
    QPushButton* fitButton = newFitButton(tr("Bring the whole blow into view (double-click in the picture)"));

    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(8, 6, 8, 0);
    bar->addWidget(m_field);
    bar->addWidget(m_fronts);
    bar->addWidget(label);
    bar->addWidget(m_section);
    bar->addStretch(1);
    bar->addWidget(fitButton);
    return bar;
}

void WavePicturePage::restoreChoices() {
    const Settings settings;
    const bool velocity = settings.value(shownFieldKey).toString() == velocityName;
    m_field->setCurrentIndex(velocity ? 1 : 0);
    m_picture->setField(velocity ? WaveQuantity::velocity : WaveQuantity::force);
    m_fronts->setChecked(settings.value(frontsKey, true).toBool());
    m_picture->setFrontsShown(m_fronts->isChecked());
}

void WavePicturePage::wire() {
    connect(m_field, &QComboBox::currentIndexChanged, this, [this](int index) {
        Settings().setValue(shownFieldKey, index == 1 ? velocityName : QStringLiteral("force"));
        m_picture->setField(index == 1 ? WaveQuantity::velocity : WaveQuantity::force);
    });
    connect(m_fronts, &QCheckBox::toggled, this, [this](bool shown) {
        Settings().setValue(frontsKey, shown);
        m_picture->setFrontsShown(shown);
        m_plot->replot(QCustomPlot::rpQueuedReplot);
    });
    connect(m_picture, &WavePicturePlot::needChanged, this, &Page::needsChanged);
    connect(m_picture, &WavePicturePlot::viewChanged, this, &WavePicturePage::showSpan);
    connect(m_plot, &QCustomPlot::afterReplot, this, &WavePicturePage::alignStrip);

    connect(m_cursors, &PictureCursors::sectionMoved, &m_observation, &Observation::setSection);
    connect(&m_observation, &Observation::sectionChanged, m_cursors, &PictureCursors::setSection);
    connect(m_cursors, &PictureCursors::timeMoved, &m_observation, &Observation::setTime);
    connect(m_playBar, &PlayBar::timeChosen, &m_observation, &Observation::setTime);
    connect(&m_observation, &Observation::timeChanged, this, &WavePicturePage::showTime);
    for (QWidget* widget : {static_cast<QWidget*>(m_plot), static_cast<QWidget*>(m_strip),
                            m_playBar->findChild<QWidget*>(QStringLiteral("timeSlider"))})
        widget->installEventFilter(this);
}

PreparePage WavePicturePage::prepare() const {
    std::vector<RunOverlay<RunWaves>> made;
    if (const WavePicture* shown = m_picture->picture()) made = shown->runs;
    return [need = m_picture->need(), runs = m_runs, made = std::move(made)](const SolvedBlow& blow) {
        if (!blow.impact.hasHistories()) return PageData();
        WavePicture picture = wavePicture(blow, blow.units, need);
        picture.runs = runOverlays(runsToDraw(blow.scenario, *runs), blow, made,
                                   [](const SolvedBlow& run, const ShownUnits&) { return runWaves(run); });
        return PageData::of(std::move(picture));
    };
}

void WavePicturePage::setRuns(const RunListPtr& runs) {
    m_runs = runs;
    emit needsChanged();
}

void WavePicturePage::setResult(const SolvedBlowPtr& blow) {
    if (blow->page<WavePicture>())
        m_picture->present(blow);
    else if (!blow->fault.isEmpty())
        m_picture->showNothing(tr("Nothing to show: %1").arg(blow->fault));
    else if (!blow->impact.hasHistories())
        m_picture->showNothing(tr("Nothing to show: there are too many waves to keep."));
    else
        return;  // the answer to an older request, before this page was there to ask
    answerLabel()->setText(largestStressText(*blow));
    m_profile->setBlow(m_picture->shown());
    m_strip->setBlow(m_picture->shown());
    showSpan();
    showTime();
    redraw();
}

// While nobody has chosen a time: when the blow is on its way to the bit.
double WavePicturePage::timeShown() const {
    if (const std::optional<double> time = m_observation.time()) return *time;
    const WavePicture* picture = m_picture->picture();
    if (!picture) return 0;
    const double begin = picture->interesting.begin;
    return begin > 0 ? begin : 0.7 * BlowWaves(*m_picture->shown()).arrival();
}

void WavePicturePage::showTime() {
    const double time = timeShown();
    m_cursors->setTime(time);
    m_profile->setTime(time);
    m_strip->setTime(time);
    m_playBar->setTime(time);
    m_playBar->setTimeText(m_strip->stateText());
}

void WavePicturePage::showSpan() {
    const WavePicture* picture = m_picture->picture();
    if (!picture) return;
    m_playBar->setSpan(m_picture->timeInView(),
                       picture->units.time.dimensionless ? 0 : m_picture->shown()->scales.time);
}

// The place below the pointer, also when a zoom has brought another one there; else what is in view.
void WavePicturePage::showReadout() {
    const QString place = m_pointer ? m_picture->readout(*m_pointer) : QString();
    const QString range = m_picture->rangeText(), fronts = m_picture->frontsText();
    QString inView = fronts.isEmpty() ? range : range + QStringLiteral(" · ") + fronts;
    for (const QString& shorter :
         {range + QStringLiteral(" · ") + fronts.section(u';', -1).trimmed(), range, QStringLiteral(" ")})
        if (m_readout->fontMetrics().horizontalAdvance(inView) >= m_readout->contentsRect().width())
            inView = shorter;
    m_readout->setText(place.isEmpty() ? inView : place);
    m_readout->setToolTip(place.isEmpty() ? range : place + u'\n' + range);
}

// The rod below lies in line with the picture above while the whole of it is in view.
void WavePicturePage::alignStrip() {
    showReadout();
    const QRect axes = m_plot->axisRect()->rect();
    m_profile->setRodEnds(axes.left(), axes.right() + 1);
    m_strip->setRodEnds(axes.left(), axes.right() + 1);
}

bool WavePicturePage::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
        m_playBar->toggle();
        return true;
    }
    if (watched == m_plot && event->type() == QEvent::MouseMove) {
        m_pointer = static_cast<QMouseEvent*>(event)->position();
        showReadout();
    }
    if (watched == m_plot && event->type() == QEvent::Leave) {
        m_pointer.reset();
        showReadout();
    }
    return PlotPage::eventFilter(watched, event);
}

}  // namespace drillwave
