// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/thrust_report.h"

#include <algorithm>
#include <cmath>

#include "core/blow/blow.h"
#include "core/blow/feed_estimate.h"
#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/numeric/run_time.h"
#include "core/report/feed_words.h"
#include "core/report/parameter_words.h"

namespace drillwave {

namespace {

constexpr std::uint64_t mostThrustPoints = 10'000;
constexpr std::size_t pointsAtATime = 8;  // a scenario may be large, and each first look has a copy

/// The range of --along or --frequency, or why there is none.
struct AskedAxis {
    std::optional<StudyAxis> axis;
    Message problem;
    bool isUsage = false;
};

AskedAxis askedAxis(const StudyQuestion& question) {
    const std::string* along = wordsOf(question, "along");
    const std::string* frequencies = wordsOf(question, "frequency");
    if (!along && !frequencies) return {};
    if (along && frequencies)
        return {{},
                translatable("--frequency VALUES is --along drill.blow_frequency=VALUES; give one of them"),
                true};
    const std::string option = along ? "--along" : "--frequency";
    ParsedAxis parsed =
        parseAxis(along ? *along : "drill.blow_frequency=" + *frequencies, customaryThrustPoints);
    if (!parsed.problem.isEmpty())
        return {{}, about(option, parsed.problem), parsed.kind != ParsedAxis::Kind::badValue};
    if (!parsed.axis.parameter)
        return {{}, about(option, translatable("pulse.shape is not a number; use sweep for it")), true};
    if (parsed.axis.count > mostThrustPoints)
        return {
            {}, {translatable("%1: at most %2 values"), {option, std::to_string(mostThrustPoints)}}, true};
    if (const Message reason = whyNotApplicable(*parsed.axis.parameter, question.scenario); !reason.isEmpty())
        return {{},
                about(option, {translatable("%1 does not apply here: %2"),
                               {std::string(parsed.axis.key()), reason}})};
    return {StudyAxis{along ? "along" : "frequency", std::move(parsed.axis)}, {}};
}

class ThrustAnswer : public StudyAnswer {
  public:
    explicit ThrustAnswer(const ThrustReport& report) : StudyAnswer(report.scenario), m_report(report) {}

    Message gap() const override {
        if (m_report.study.reason.isEmpty()) return {};
        return {translatable("could not be solved: %1"), {m_report.study.reason}};
    }
    Message gapInRows() const override {
        if (!m_report.along) return {};
        const std::vector<ThrustPoint>& points = m_report.along->curve.points;
        const auto isUnsolved = [](const ThrustPoint& point) { return !point.reason.isEmpty(); };
        const auto first = std::ranges::find_if(points, isUnsolved);
        if (first == points.end()) return {};
        return {translatable("%1 of %2 points could not be solved: their cells are empty; the first: %3"),
                {std::to_string(std::ranges::count_if(points, isUnsolved)), std::to_string(points.size()),
                 first->reason}};
    }
    bool hasRows() const override { return m_report.along.has_value(); }
    std::vector<Message> sentences(const ReadingStyle& style) const override {
        return thrustSentences(scenario(), feed(), m_report.study.shareFull, style);
    }
    StudyFigure figure(std::size_t /*view*/) const override { return thrustFigure(m_report); }
    std::optional<FigurePoint> placeOf(const Scenario& present, std::size_t /*view*/) const override {
        Scenario asked = present;
        asked.title.clear();
        const std::optional<double> value = along().value(present);
        return value && asked == scenario() ? std::optional(FigurePoint{*value, feed().effective()})
                                            : std::nullopt;
    }
    std::optional<FigurePoint> placeOfBlow(const Blow& blow) const override {
        if (!along().applies(blow.scenario)) return std::nullopt;
        const std::optional<double> value = along().value(blow.scenario);
        const std::optional<double> need =
            thrustNeeded(blow.scenario, blow.summary.cor, blow.summary.transferred);
        return value && need ? std::optional(FigurePoint{*value, need}) : std::nullopt;
    }
    StudyTable table(const ReadingStyle& style) const override;
    std::string text(const ReadingStyle& style) const override { return thrustText(m_report, style); }
    std::string json(const std::string& scenarioText) const override {
        return thrustJson(m_report, scenarioText);
    }
    std::string csv(OutputUnits /*units*/) const override { return thrustCsv(*m_report.along); }

  private:
    const FeedEstimate& feed() const { return m_report.study.feed; }
    const Parameter& along() const { return *m_report.along->axis.parameter; }

    ThrustReport m_report;
};

/// The columns are narrow.
const char* shortLabelOf(ThrustCase which) {
    if (which == ThrustCase::gapQuantile) return translatable("95 % of gaps");
    return which == ThrustCase::elasticWorst ? translatable("elastic, worst gap") : labelOf(which);
}

StudyTable ThrustAnswer::table(const ReadingStyle& style) const {
    StudyTable table{
        .rows = {{translatable("required"),
                  translatable("Mean force that balances a blow which starts at rest on the rock")},
                 {translatable("return in time"),
                  translatable(
                      "At this feed an undamped rigid rod is back at the rock before the next blow")},
                 {translatable("margin"), translatable("Effective feed force over the required one, less 1")},
                 {translatable("enough up to"),
                  translatable(
                      "Up to this blow frequency the effective feed force is at least the required one")}},
        .cells = std::vector<std::vector<StudyTable::Cell>>(4)};
    for (const ThrustCase which : thrustCases) {
        const ThrustNeed& need = feed().need(which);
        if (!need.known) continue;
        table.columns.push_back({shortLabelOf(which), labelOf(which)});
        const std::string rebound = "e = " + style.number(need.cor.value, 4);
        table.cells[0].push_back({style.quantity(need.thrust, Quantity::force, 4), rebound});
        table.cells[1].push_back({style.quantity(need.thrustUndamped, Quantity::force, 4), rebound});
        table.cells[2].push_back({need.margin ? style.signedPercent(*need.margin) : ""});
        table.cells[3].push_back(
            {need.frequencyLimit ? style.quantity(*need.frequencyLimit, Quantity::frequency, 4) : ""});
    }
    return table;
}

/// Follows the axis as on a page, with the memory of earlier questions: a feed force that is dragged costs
/// next to nothing.
void follow(ThrustReport& report, GapReboundFinder& finder, const StudyWork& work) {
    const SweepAxis& axis = report.along->axis;
    const double value = axis.parameter->value(report.scenario).value_or(std::nan(""));
    const ThrustPoint here = thrustPoint(report.scenario, value, finder, work.stop);
    report.study.feed = here.feed;
    report.study.reason = here.reason;
    if (!here.reason.isEmpty()) return;
    const auto show = [&](const ThrustCurve& soFar) {
        work.progress(double(soFar.points.size()) / double(axis.count));
        if (soFar.points.size() % pointsAtATime != 0) return;
        report.along->curve = soFar;
        work.show(std::make_shared<const ThrustAnswer>(report));
    };
    report.along->curve =
        thrustAlong(report.scenario, *axis.parameter, valuesOf(axis), finder, work.stop, show);
}

StudyAnswerPtr runThrust(const StudyQuestion& question, const StudyWork& work) {
    const Stopwatch watch;
    ThrustReport report{.scenario = question.scenario};
    const std::optional<StudyAxis> asked = askedAxis(question).axis;
    if (asked) report.along = ThrustAlong{asked->axis, {}};
    if (work.memory && asked) {
        if (!work.memory->has_value()) work.memory->emplace<GapReboundFinder>();
        follow(report, *std::any_cast<GapReboundFinder>(work.memory), work);
        return std::make_shared<const ThrustAnswer>(report);
    }
    const double ofRows = !asked ? 0 : work.isForText ? 0.5 : 1;  // share of the work
    if (asked)
        report.along->curve = thrustAlong(
            report.scenario, *asked->axis.parameter, valuesOf(asked->axis), work.threads, work.stop,
            [&](const ThrustCurve& soFar) {
                work.progress(ofRows * double(soFar.points.size()) / double(asked->axis.count));
            },
            work.limits);
    if (work.isForText)
        report.study = studyThrust(
            report.scenario, work.stop, [&](double share) { work.progress(ofRows + (1 - ofRows) * share); },
            anyNumberOfPieces, work.limits);
    report.runTime = watch.seconds();
    return std::make_shared<const ThrustAnswer>(report);
}

}  // namespace

StudyFigure thrustFigure(const ThrustReport& report) {
    const SweepAxis& axis = report.along->axis;
    const KeptParameter installed = findParameter("drill.thrust");
    const SiValues force{Quantity::force, *thrustNeeded(report.scenario, 0)};  // does not follow from e
    std::vector<ThrustPoint> points;
    for (const ThrustPoint& point : report.along->curve.points)
        if (point.reason.isEmpty()) points.push_back(point);
    std::ranges::sort(points, {}, &ThrustPoint::value);
    const auto ofEach = [&](const auto& value) {
        std::vector<double> values;
        for (const ThrustPoint& point : points) values.push_back(value(point));
        return values;
    };
    const std::vector<double> x = ofEach([](const ThrustPoint& point) { return point.value; });
    const std::vector<double> wanted = valuesOf(axis);
    const auto [from, to] = std::ranges::minmax(wanted);
    StudyPanel panel{.x = {.quantity = axis.parameter,
                           .isLogarithmic = axis.kind == SweepAxis::Kind::logarithmic,
                           .range = std::pair(from, to),
                           .target = AxisTarget{axis.parameter}},
                     .y = {.title = translatable("feed force"), .quantity = force, .isFromZero = true}};
    std::vector<Message> cases;
    for (const ThrustCase which : thrustCases) {
        if (points.empty() || !points.front().need(which).known) continue;
        cases.emplace_back(labelOf(which));
        panel.series.push_back(
            {.role = static_cast<SeriesRole>(which),
             .legend = labelOf(which),
             .x = x,
             .y = ofEach([&](const ThrustPoint& point) { return point.need(which).thrust; }),
             .upper = ofEach([&](const ThrustPoint& point) { return point.need(which).thrustUndamped; }),
             .isFilled = which == ThrustCase::scenario});
    }
    FigureSeries feed{.stroke = SeriesStroke::strong, .legend = translatable("installed feed force")};
    if (!points.empty() && points.front().feed.force) {
        feed.x = x;
        feed.y = ofEach([](const ThrustPoint& point) { return *point.feed.effective(); });
        const bool isWeighted = points.front().feed.force->weight.has_value();
        if (isWeighted) feed.legend = translatable("effective force, with weight along the hole");
        feed.texts = {{isWeighted ? translatable("effective %1") : translatable("installed %1"),
                       {{feed.y.front(), force}}}};
        if (axis.key() != installed->key) feed.dragged = AxisTarget{installed};
    }
    panel.layers = {
        .x = x,
        .edges = {ofEach([](const ThrustPoint& point) { return point.feed.balance; }),
                  ofEach([](const ThrustPoint& point) { return point.need(ThrustCase::scenario).thrust; }),
                  ofEach([](const ThrustPoint& point) { return point.feed.largest().thrust; }),
                  ofEach([](const ThrustPoint& point) { return point.feed.largest().thrustUndamped; })},
        .clear = feed.y};
    for (const FeedState state : {FeedState::pushedBack, FeedState::belowRequired,
                                  FeedState::requiredAtThisGap, FeedState::requiredMet, FeedState::returnMet})
        panel.layers.names.push_back(Message::ofTable(feedWord(state)));
    panel.series.push_back(std::move(feed));
    return {
        .caption = {{translatable(
            "Each strip runs from the required feed force to the one that returns the rod in time.")}},
        .panels = {panel},
        .summary = {{translatable("Feed force over %1, for %2. Each strip runs from the required feed force "
                                  "to the one that returns the rod in time. The shades behind the strips "
                                  "show what a feed force does for the rebound of this blow."),
                     {{.words = labelMessage(*axis.parameter)}, {.words = inOneLine(std::move(cases))}}}},
        .paperHeight = 120};
}

const Study& thrustStudy() {
    static const Study study{
        .name = "thrust",
        .title = translatable("Feed"),
        .plotTitle = translatable("Required feed"),
        .summary = "feed force that single blows require, and whether the installed one is sufficient",
        .details =
            "Estimates from single blows whether the installed feed force is sufficient. Prints four cases: "
            "this\nblow, 95 % of all gaps between bit and rock, rigid rock (e = 1), and the worst gap. The "
            "worst gap\nrequires the highest feed force on elastic rock (gamma = 1). In the columns of the "
            "table (theory\n§10), f is the blow frequency, I0 the impulse of a blow and e the coefficient of "
            "restitution:\n  required        f I0 (1 + e), the feed force that balances the blows\n  return "
            "in time  f I0 (1 + 2e), the feed force that brings an undamped rigid rod back to the rock\n     "
            "             before the next blow\n  margin          effective over required feed force, less "
            "1\n  enough up to    highest blow frequency at which the effective feed force still\n           "
            "       reaches the required one\nIf the feed force is below f I0, the blows push the machine "
            "back. The effective feed force is the\ninstalled one; if drill.inclination is given, the weight "
            "of rod and drill.machine_mass along the\nhole is added. For consecutive blows, use `drillwave "
            "drill`; its --scan\ndrill.thrust=START:STOP:COUNT shows the effect of more feed force. FILE "
            "must have physical units\nand drill.blow_frequency; margins need drill.thrust, the installed "
            "feed force. For drill strings,\nI0 is the impulse that the hammer transfers, and only this blow "
            "and rigid rock are printed.",
        .csvHelp = "also write the table of --along to FILE.csv; -o - prints this CSV instead of the tables",
        .options = {{.key = "along",
                     .value = "KEY=VALUES",
                     .help = "also print a table over the values of this parameter. VALUES is "
                             "START:STOP[:COUNT], START:STOP[:COUNT]:log (equal ratios) or A,B,C. Default "
                             "COUNT: 101, or every integer if the parameter is an integer",
                     .control = RangeControl{{"drill.blow_frequency"}},
                     .label = translatable("over")},
                    {.key = "frequency",
                     .value = "VALUES",
                     .help = "vary the blow frequency: short for --along drill.blow_frequency=VALUES"}},
        .views = {},
        .firstLook = "",
        .clickHelp = "",
        .hasSi = false,
        .whyNot =
            [](const Scenario& scenario) { return hasUnits(scenario) ? Message() : thrustProblem(scenario); },
        .elsewhere = translatable(
            "The required feed force needs a scenario in physical units. This scenario is given by its "
            "dimensionless groups, without blow frequency and forces."),
        .reduce = [](Scenario&) {},
        .problem = [](const StudyQuestion& question) -> std::optional<StudyProblem> {
            const AskedAxis asked = askedAxis(question);
            if (asked.problem.isEmpty()) return std::nullopt;
            return StudyProblem{"", asked.problem, asked.isUsage};
        },
        .run = runThrust,
        .isPhysical = true,
        .isOfFeed = true,
        .asked = {"drill.blow_frequency", "drill.thrust"},
        .lacks =
            [](const Scenario& scenario, const ReadingStyle& style) {
                const Message problem = thrustProblem(scenario);
                return problem.isEmpty() || !style.isPrinted() ? problem
                                                               : requiredFeedMessage(scenario, {}, style);
            },
        .axis = [](const StudyQuestion& question) { return askedAxis(question).axis; },
        .threadsHelp = "number of processor threads for --along (default: all)",
        .hasWorkLimit = true,
        .tableName = translatable("Required feed"),
        .marksBlows = true,
    };
    return study;
}

}  // namespace drillwave
