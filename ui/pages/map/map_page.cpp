// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/map/map_page.h"

#include <QMouseEvent>
#include <QSignalBlocker>

#include "core/model/assignments.h"
#include "core/model/section_parameter.h"
#include "core/report/row_csv.h"
#include "core/study/map/map_rows.h"
#include "core/study/rows/study_plan.h"
#include "core/yaml/preset_file.h"
#include "ui/form/choice_box.h"
#include "ui/pages/map/level_field.h"
#include "ui/pages/study/axis_fields.h"
#include "ui/pages/study/labelled_control.h"
#include "ui/pages/study/output_box.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

// More are for the command: their picture is no better, and their numbers would have to be kept several
// times.
constexpr int pointsEachWay[] = {20, 40, 50, 100, 200, 400, 1000};

/// Returns the whole range of the elasticity.
StudyRange wholeElasticity(const Parameter& gamma) {
    return {gamma, 0.01, 1, false};
}

/// Returns the units of the columns of a map for results on show in `system`.
OutputUnits outputUnitsFor(const Output& output, UnitSystem system) {
    const bool isNumber = output.quantity() == Quantity::ratio;
    return isNumber || system == UnitSystem::dimensionless ? OutputUnits::dimensionless : OutputUnits::si;
}

}  // namespace

MapPage::MapPage(Document& document, QWidget* parent)
    : StudyPage(document, parent),
      m_x(new AxisFields(tr("x"), {"bit_rock.stiffness", "beta"}, document.units(), this)),
      m_y(new AxisFields(tr("y"), {"bit_rock.gamma", "delta"}, document.units(), this)),
      m_output(new OutputBox(this)),
      m_points(pointsBox()),
      m_levels(new LevelField(this)),
      m_newest(std::make_shared<std::atomic<int>>(0)),
      m_study(&answerMap) {
    m_x->setObjectName(QStringLiteral("x"));
    m_y->setObjectName(QStringLiteral("y"));
    PlotWidget* plot =
        arrange({m_x, m_y, labelled(tr("colour"), m_output, this), labelled(tr("contours"), m_levels, this),
                 labelled(tr("points"), m_points, this)});
    m_frame = new FigureFrame(plot);
    useFrame(*m_frame, tr("Result over two parameters"));
    plot->setDataText([this](char separator) {
        QByteArray text = csv();
        return separator == ',' ? text : text.replace(',', separator);
    });
    watch(m_study.job());
    wire();
}

ChoiceBox* MapPage::pointsBox() {
    auto* box = new ChoiceBox(this);
    box->setObjectName(QStringLiteral("points"));
    box->setAccessibleName(tr("Points of the map"));
    box->setToolTip(tr("Number of values of each of the two parameters"));
    for (const int points : pointsEachWay) box->addItem(QStringLiteral("%1 × %1").arg(points), points);
    box->setCurrentIndex(box->findData(studyPlan(scenario()).mapPoints));
    return box;
}

void MapPage::wire() {
    for (const AxisFields* fields : {m_x, m_y})
        connect(fields, &AxisFields::changed, this, &MapPage::requestUpdate);
    connect(m_points, &QComboBox::currentIndexChanged, this, &MapPage::requestUpdate);
    connect(m_levels, &LevelField::changed, this, &MapPage::requestUpdate);
    connect(m_output, &OutputBox::changed, this, [this] {
        takeUsualLevels();
        requestUpdate();
    });
    connect(plot(), &PlotWidget::placeTaken, this,
            [this](const QCPAxisRect* rect, QPointF at, Qt::KeyboardModifiers modifiers) {
                if (m_frame->panelIn(rect) != std::size_t(MapPanel::map) || !m_frame->field()) return;
                const MapGrid& grid = m_shown->grid;
                if (const auto point = m_frame->field()->pointAt(at))
                    take(inOrder(grid.xs()[point->column], grid.ys()[point->row]), modifiers);
            });
    connect(m_frame, &FigureFrame::crosshairHeld, this, [this] { m_gesture = document().newGesture(); });
    connect(m_frame, &FigureFrame::crosshairDragged, this, &MapPage::dragTo);
    takeUsualLevels();
}

OutputColumn MapPage::column() const {
    return {&m_output->output(), outputUnitsFor(m_output->output(), unitsFor(scenario()).system)};
}

QString MapPage::axisWord(const AxisFields& fields) const {
    const StudyRange& range = fields.range();
    const auto most = static_cast<std::uint64_t>(m_points->currentData().toInt());
    return QString::fromStdString(range.text() + ":" + std::to_string(range.pointsWithin(most)) +
                                  range.tail());
}

// Built from the words of the command, so that both have the same values.
MapStudy MapPage::study() const {
    return {.base = scenario(),
            .x = parseAxis(axisWord(*m_x).toStdString()).axis,
            .y = parseAxis(axisWord(*m_y).toStdString()).axis,
            .output = column()};
}

// Sets the range of a parameter that the fields have chosen themselves: the whole range of the elasticity,
// two periods of the gap.
void MapPage::offer(AxisFields& fields) {
    const KeptParameter before = fields.range().parameter;
    fields.present(scenario());
    const KeptParameter parameter = fields.range().parameter;
    if (!parameter || parameter == before) return;
    if (parameter->key.ends_with("gamma")) fields.setRange(wholeElasticity(*parameter));
    if (parameter->key == "delta") fields.setRange({parameter, 0, 2, false});
}

void MapPage::takeUsualLevels() {
    m_levels->setLevels(usualLevels(m_output->output()));
}

// A size of the string against the rock, where a rod has its rock against the elasticity.
void MapPage::followForm() {
    const KeptParameter size = typicalSize(scenario());
    if (m_hasSize == (size != nullptr)) return;
    m_hasSize = size != nullptr;
    const QSignalBlocker quietPoints(m_points), quietX(m_x), quietY(m_y);
    m_points->setCurrentIndex(m_points->findData(studyPlan(scenario()).mapPoints));
    if (size) {
        m_x->setRange(rangeAround(*size, scenario()));
        m_y->setRange(rangeAround(*findParameter("bit_rock.stiffness"), scenario()));
    } else if (hasUnits(scenario())) {
        m_y->setRange(wholeElasticity(*findParameter("bit_rock.gamma")));
    }
}

void MapPage::ask() {
    followForm();
    offer(*m_x);
    offer(*m_y);
    m_output->present(scenario());
    if (!m_x->isValid() || !m_y->isValid()) return;
    MapQuestion question{
        .study = study(), .levels = m_levels->levels(), .number = *m_newest + 1, .newest = m_newest};
    const MapOutput output = mapOutput(question.study);
    const double factor = figureUnits(unitsFor(scenario())).of(output.axis.quantity).factor * output.perValue;
    for (double& level : question.levels) level /= factor;
    const std::vector<Message> problems = problemsOf(question.study);
    m_problem = problems.empty() ? QString() : translated(problems.front());
    if (question.study.x.parameter == question.study.y.parameter)
        m_problem = tr("Both axes are %1: choose another parameter for one of them.")
                        .arg(parameterName(*question.study.x.parameter));
    if (!m_problem.isEmpty()) return m_study.job().cancel();
    const int number = question.number;
    if (m_study.ask(std::move(question))) *m_newest = number;
}

void MapPage::present() {
    if (!m_problem.isEmpty()) {
        m_shown.reset();
        showNothing(m_problem);
        say(QString());
        return;
    }
    const std::shared_ptr<const MapReport> report = m_study.job().value();
    if (!report) return;
    const ShownUnits units = unitsFor(report->study.base);
    const auto placeOf = [&](const Scenario& of) { return mapPlaceOf(report->study, of); };
    const auto pixelOf = [this](const FigurePoint& at) {
        return QPointF(at.x * m_frame->xUnit().factor, *at.y * m_frame->yUnit().factor);
    };
    const std::optional<FigurePoint> here = placeOf(scenario());
    const MapSection section = mapSectionAt(*report, here);
    if (report != m_shown || !(units == m_shownUnits) || section != m_section) {
        m_shown = report;
        m_shownUnits = units;
        m_section = section;
        draw();
    }
    m_frame->setHere(here ? std::optional(pixelOf(*here).x()) : std::nullopt,
                     here ? std::optional(pixelOf(*here).y()) : std::nullopt);
    QVector<RunMark> marks;
    for (const Run& run : runs())
        if (const auto place = placeOf(run.contents.scenario); place && run.isShown)
            marks.append({run.number, run.title(), pixelOf(*place)});
    m_frame->setRuns(marks);
    speak();
}

void MapPage::draw() {
    const bool isFirst = m_frame->isEmpty();
    m_frame->present({mapFigure(m_shown, m_section, builtInPresets()), figureUnits(m_shownUnits)});
    if (isFirst) plot()->keyPoint().offer(m_frame->keyPlaces());
    plot()->installEventFilter(this);  // before the crosshair, which keeps what it drags
    m_frame->giveMeanings(*plot());
    redraw();
}

void MapPage::speak() {
    const std::optional<FigureText> answer = mapAnswer(*m_shown);
    const QString range = m_frame->textSummary(), here = m_readout.isEmpty() ? hereText() : m_readout;
    if (answer)
        say(m_frame->textOf(*answer), QStringLiteral("%1 · %2").arg(range, here));
    else
        say(range, here);
}

// The blow of the crosshair, solved on its own.
QString MapPage::hereText() const {
    const QString help =
        tr("Click on a line or preset to use that point; Shift+click pins it. The crosshair can be dragged.");
    if (!blow() || !blow()->fault.isEmpty()) return help;
    const auto value = m_shown->study.output.value({blow()->summary, blow()->scenario}, blow()->scales);
    if (!value) return help;
    const MapOutput output = mapOutput(m_shown->study);
    return tr("here %1. %2")
        .arg(m_frame->textOf(
                 {"%1 = %2",
                  {{.words = output.axis.title}, {*value * output.perValue, output.axis.quantity, 5}}}),
             help);
}

std::vector<ParameterValue> MapPage::inOrder(double x, double y) const {
    const MapStudy& study = m_shown->study;
    const ParameterValue values[] = {{study.x.parameter, x}, {study.y.parameter, y}};
    const Assignments assignments({study.x.key(), study.y.key()});
    std::vector<ParameterValue> ordered;
    for (const std::size_t i : assignments.order()) ordered.push_back(values[i]);
    return ordered;
}

void MapPage::dragTo(QPointF place) {
    if (!m_shown) return;
    const MapStudy& study = m_shown->study;
    const FigurePoint before = *mapPlaceOf(study, scenario());
    // A line that stays keeps its value, with all digits.
    const auto si = [&](const Parameter& parameter, double shown, double stayed, double factor) {
        return shown == stayed * factor ? stayed
                                        : document().units().fieldUnit(parameter).toSi(readable(shown));
    };
    document().assign(inOrder(si(*study.x.parameter, place.x(), before.x, m_frame->xUnit().factor),
                              si(*study.y.parameter, place.y(), *before.y, m_frame->yUnit().factor)),
                      m_gesture);
}

QString MapPage::obstacle() const {
    return m_problem.isEmpty() ? StudyPage::obstacle() : m_problem;
}

QByteArray MapPage::csv() const {
    const MapReport* report = m_study.value();
    if (!report) return {};
    QByteArray bytes;
    RowCsv sink([&](std::string_view text) {
        bytes.append(text.data(), qsizetype(text.size()));
        return true;
    });
    giveRows(report->study, report->grid, sink);
    return bytes;
}

QStringList MapPage::commandWords() const {
    if (!m_problem.isEmpty() || !m_x->isValid() || !m_y->isValid()) return {};
    QStringList words{
        QStringLiteral("map"),
        QStringLiteral("--x"),
        axisWord(*m_x),
        QStringLiteral("--y"),
        axisWord(*m_y),
        QStringLiteral("--output"),
        QString::fromUtf8(m_output->output().name.data(), qsizetype(m_output->output().name.size()))};
    if (column().units == OutputUnits::si) words << QStringLiteral("--si");
    return words;
}

QString MapPage::readoutAt(QPointF pixel) const {
    const QCPAxisRect* rect = plot()->axisRectAt(pixel);
    if (m_frame->panelIn(rect) != std::size_t(MapPanel::map) || !rect->rect().contains(pixel.toPoint()))
        return {};
    return m_frame->fieldWords({rect->axis(QCPAxis::atBottom)->pixelToCoord(pixel.x()),
                                rect->axis(QCPAxis::atLeft)->pixelToCoord(pixel.y())});
}

bool MapPage::eventFilter(QObject* watched, QEvent* event) {
    if (watched == plot() && (event->type() == QEvent::MouseMove || event->type() == QEvent::Leave)) {
        m_readout = event->type() == QEvent::Leave ? QString()
                                                   : readoutAt(static_cast<QMouseEvent*>(event)->position());
        if (m_shown) speak();
    }
    return StudyPage::eventFilter(watched, event);
}

}  // namespace drillwave
