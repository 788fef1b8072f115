// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/figure_page.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/archive/result_scenario.h"
#include "core/numeric/available_threads.h"
#include "core/report/blow_csv.h"
#include "ui/form/choice_box.h"
#include "ui/form/rig_dialog.h"
#include "ui/pages/study/answer_table.h"
#include "ui/pages/study/missing_fields.h"
#include "ui/pages/study/option_fields.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/run_overlay.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {
namespace {

[[noreturn]] void fail(const Message& reason) {
    throw std::runtime_error(translated(reason).toStdString());
}

// Away from the window's thread.
StudyAnswerPtr answered(const Study& study, const StudyQuestion& question,
                        const StudyFeed<StudyAnswerPtr>& feed, std::any& memory) {
    if (const std::optional<StudyProblem> problem = study.problem(question)) fail(problem->reason);
    constexpr std::size_t parts = 1000;  // of the work
    StudyAnswerPtr answer = study.run(
        question, {.stop = feed.stop,
                   .progress =
                       [&](double share) {
                           feed.tell({.done = static_cast<std::size_t>(share * parts), .wanted = parts});
                       },
                   .show = feed.show,
                   .threads = availableThreads(),
                   .memory = &memory});
    if (!feed.stop.stop_requested() && !answer->gap().isEmpty()) fail(answer->gap());
    return answer;
}

// A value that the hand has chosen to a pixel needs no more digits than that.
double readable(double value, const QCPAxis& axis) {
    const double step = std::abs(axis.pixelToCoord(axis.coordToPixel(value) + 1) - value);
    if (!(step > 0) || !std::isfinite(step) || value == 0) return value;
    constexpr int most = 15;  // digits that a double keeps
    const double digits = std::floor(std::log10(std::abs(value) / step)) + 1;
    // Through text: 0.3, not 0.30000000000000004.
    return QString::number(value, 'g', std::clamp(int(digits), 1, most)).toDouble();
}

}  // namespace

FigurePage::FigurePage(const Study& study, Document& document, QWidget* parent)
    : StudyPage(document, parent),
      m_study(study),
      m_options(new OptionFields(study, document.units(), this)),
      m_asked([&study, memory = std::make_shared<std::any>()](const StudyQuestion& question,
                                                              const StudyFeed<StudyAnswerPtr>& feed) {
          return answered(study, question, feed, *memory);
      }),
      m_ofRuns([&study](const StudyQuestion& question,
                        const std::stop_token& stop) -> std::optional<StudyAnswerPtr> {
          if (study.problem(question)) return std::nullopt;
          StudyAnswerPtr answer = study.run(question, {.stop = stop});
          return answer->gap().isEmpty() ? std::optional(answer) : std::nullopt;
      }) {
    setObjectName(fromView(study.name));
    QList<QWidget*> controls;
    if (!study.views.empty()) {
        m_view = new ChoiceBox(this);
        m_view->setObjectName(QStringLiteral("output"));
        m_view->setAccessibleName(tr("Result"));
        m_view->setToolTip(tr("Which result is shown"));
        for (const char* view : study.views) m_view->addItem(translated(view));
        connect(m_view, &QComboBox::currentIndexChanged, this, &FigurePage::present);
        controls << m_view;
    }
    controls << m_options->widgets();
    if (!study.asked.empty()) {
        m_missing = new MissingFields(study.asked, document.units(), this);
        connect(m_missing, &MissingFields::entered, this, [this](const KeptParameter& parameter, double si) {
            load({{parameter, si}});
        });
        controls << m_missing;
    }
    PlotWidget* plot = arrange(controls);
    if (study.tableName) addBelow(m_table = new AnswerTable(translated(study.tableName), this));
    m_frame = new FigureFrame(plot);
    useFrame(*m_frame, translated(study.plotTitle));
    watch(m_asked.job());
    watchBeside(m_ofRuns.activity());
    connect(m_options, &OptionFields::changed, this, &FigurePage::requestUpdate);
    connect(plot, &PlotWidget::placeTaken, this, &FigurePage::takePlace);
    connect(m_frame, &FigureFrame::seriesHeld, this, &FigurePage::hold);
    connect(m_frame, &FigureFrame::seriesMoved, this, &FigurePage::moveHeld);
    connect(&document.units(), &UnitChoice::changed, this, [this] {
        m_shown = {};  // of the axes, too
        if (isVisible()) present();
    });
}

QString FigurePage::title() const {
    return translated(m_study.title);
}

QString FigurePage::elsewhere() const {
    const QString words = translated(m_study.elsewhere);
    return m_study.isPhysical ? words + QLatin1Char(' ') + waysToPhysicalUnits() : words;
}

Message FigurePage::lacking() const {
    return m_study.lacks ? m_study.lacks(scenario(), LocalStyle::of(document().units())) : Message();
}

void FigurePage::ask() {
    m_options->present(scenario());
    if (m_missing) m_missing->present(scenario());
    if (const Message why = lacking(); !why.isEmpty()) {
        m_asked.job().forget();
        return refuse(translated(why));
    }
    m_asked.ask(m_study.question(scenario(), m_options->words()));
}

void FigurePage::refuse(const QString& why) {
    m_shown = {};
    if (m_table) m_table->clearContents();
    showNothingAsked(why);
}

FigurePage::Shown FigurePage::wanted() const {
    Shown wanted;
    if (!m_asked.job().value()) return wanted;
    wanted.answer = *m_asked.job().value();
    wanted.view = m_view ? static_cast<std::size_t>(m_view->currentIndex()) : 0;
    const Scenario& studied = wanted.answer->scenario();
    const UnitChoice& choice = document().units();
    wanted.units = m_study.isPhysical
                       ? shownUnits(choice.physicalSystem(), scalesOf(studied), choice.chosen())
                       : unitsFor(studied);
    return wanted;
}

void FigurePage::present() {
    if (m_asked.job().state() == StudyState::failed) return refuse(m_asked.job().problem());
    Shown shown = wanted();
    if (!shown.answer) return;
    const bool isNew = !(shown == m_shown);
    if (isNew) m_shown = std::move(shown);
    if (isNew) draw();
    placeHere();
    askRuns();
    showRuns();
}

void FigurePage::draw() {
    const bool isFirst = m_frame->isEmpty();
    const StudyFigure figure = m_shown.answer->figure(m_shown.view);
    m_frame->present({figure, figureUnits(m_shown.units)});
    if (isFirst) plot()->keyPoint().offer(m_frame->keyPlaces());
    m_frame->giveMeanings(*plot());
    m_shownRuns.reset();  // over other values or in other units
    if (m_table) m_table->present(m_shown.answer->table(LocalStyle::of(document().units())));
    if (figure.isPreview)
        say(translated(m_study.firstLook));
    else
        say(translatedEach(m_shown.answer->sentences(LocalStyle::of(document().units())))
            << QStringList(*m_study.clickHelp ? 1 : 0, translated(m_study.clickHelp)));
    redraw();
}

void FigurePage::placeHere() {
    const std::optional<FigurePoint> place = m_shown.answer->placeOf(scenario(), m_shown.view);
    if (!place) return m_frame->setHere({}, {});
    m_frame->setHere(place->x * m_frame->xUnit().factor,
                     place->y ? std::optional(*place->y * m_frame->yUnit().factor) : std::nullopt);
}

// Others have nothing to lay over.
bool FigurePage::isCompared(const Run& run) const {
    return run.isShown && run.isSolved() && m_study.whyNot(run.contents.scenario).isEmpty();
}

StudyQuestion FigurePage::questionOf(const Run& run) const {
    return m_study.question(run.contents.scenario, m_options->words());
}

void FigurePage::askRuns() {
    if (m_study.marksBlows) return;
    std::vector<StudyQuestion> questions;
    for (const Run& run : runs())
        if (isCompared(run)) questions.push_back(questionOf(run));
    m_ofRuns.ask(questions);
}

void FigurePage::showRuns() {
    if (m_study.marksBlows) return markRuns();
    if (!m_ofRuns.answers()) return;
    if (m_shownRuns == runList() && m_shownAnswers == m_ofRuns.answers()) return;
    m_shownRuns = runList();
    m_shownAnswers = m_ofRuns.answers();
    const StudyFigure figure = m_shown.answer->figure(m_shown.view);
    const StudyPanel& panel = figure.panels.front();
    const std::vector<double>& along = panel.series.front().x;
    const double until = along.empty() ? 0 : along.back() * m_frame->xUnit().factor;
    QVector<RunCurve> curves;
    QVector<RunMark> marks;
    for (const Run& run : runs()) {
        if (!isCompared(run)) continue;
        const auto units = unitsOf(*run.blow, m_shown.units, scalesOf(m_shown.answer->scenario()));
        const StudyAnswerPtr* found = m_ofRuns.find(questionOf(run));
        if (!units || !found) continue;
        const FigureUnits own = figureUnits(*units);
        const double x = own.of(panel.x.quantity).factor, y = own.of(panel.y.quantity).factor;
        if (const auto series = (*found)->overlay(m_shown.view, until / x)) {
            QVector<QCPGraphData> points;
            for (std::size_t i = 0; i < series->x.size(); ++i)
                appendFinite(points, series->x[i] * x, series->y[i] * y);
            curves.append({run.number, run.title(), graphData(points)});
        }
        const std::optional<FigurePoint> place = (*found)->placeOf(run.contents.scenario, m_shown.view);
        if (place && place->y && place->x * x <= until)
            marks.append({run.number, run.letter(), QPointF(place->x * x, *place->y * y)});
    }
    m_frame->setRuns(marks, curves);
    m_frame->giveMeanings(*plot());
    plot()->replot(QCustomPlot::rpQueuedReplot);
}

void FigurePage::markRuns() {
    QVector<RunMark> marks;
    for (const Run& run : runs()) {
        if (!isCompared(run)) continue;
        const std::optional<FigurePoint> place = m_shown.answer->placeOfBlow(*run.blow);
        if (place && place->y)
            marks.append({run.number,
                          run.title(),
                          {place->x * m_frame->xUnit().factor, *place->y * m_frame->yUnit().factor}});
    }
    m_frame->setRuns(marks);
}

void FigurePage::takePlace(const QCPAxisRect* rect, QPointF at, Qt::KeyboardModifiers modifiers) {
    const AxisTarget* target = m_frame->targetIn(rect);
    if (!m_shown.answer || !target) return;
    const double shown = m_study.isPhysical ? readable(at.x(), *rect->axis(QCPAxis::atBottom)) : at.x();
    const double value = shown / m_frame->xUnit().factor * target->factor;
    take({{target->parameter, std::max(target->parameter->hard.low, value)}}, modifiers);
}

void FigurePage::hold(double y) {
    const KeptParameter& parameter = m_frame->dragged()->parameter;
    m_held = {document().newGesture(), parameter->value(scenario()).value_or(0), y};
}

// The line may be the sum of the value and others: the value moves by as much.
void FigurePage::moveHeld(double y) {
    const AxisTarget* target = m_frame->dragged();
    if (!target) return;
    const double unit = m_frame->yUnit().factor / target->factor;
    const double value = m_held.value + (y - m_held.y) * target->factor;
    const double shown = std::max(target->parameter->hard.low, value) * unit;
    document().assign(*target->parameter, readable(shown, *m_frame->graph()->valueAxis()) / unit,
                      m_held.gesture);
}

QByteArray FigurePage::csv() const {
    const StudyAnswer& answer = **m_asked.value();
    const OutputUnits units =
        m_study.hasSi && hasUnits(answer.scenario()) ? OutputUnits::si : OutputUnits::dimensionless;
    return QByteArray::fromStdString(scenarioHeader(completeScenarioText(document().contents())) +
                                     answer.csv(units));
}

QStringList FigurePage::commandWords() const {
    if (!lacking().isEmpty()) return {};
    QStringList words{fromView(m_study.name)};
    const StudyWords given = m_options->words();
    for (const StudyOption& option : m_study.options)  // in the order of the help
        if (const auto found = given.find(option.key); found != given.end())
            words << QStringLiteral("--") + fromView(option.key) << QString::fromStdString(found->second);
    if (m_study.hasSi && hasUnits(scenario())) words << QStringLiteral("--si");
    return words;
}

}  // namespace drillwave
