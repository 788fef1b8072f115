// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/gap_report.h"

#include <cmath>

#include "core/model/parameter.h"
#include "core/model/scales.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

constexpr double mostMean = 1e6;  // [d0]
constexpr int mostPeriods = 20;   // laid over another curve: with a small blow there could be thousands

/// The distribution that the options ask for, or what is wrong with them.
struct AskedGap {
    std::optional<NormalGap> normal;
    std::optional<StudyProblem> problem;
};

/// Reads a gap in d0: scenarios with units take a length, the others a multiple of d0.
double readGap(const StudyQuestion& question, std::string_view option, double least, double most,
               AskedGap& asked) {
    const bool isDimensional = hasUnits(question.scenario);
    const Quantity quantity = isDimensional ? Quantity::length : Quantity::ratio;
    const TypedQuantity typed =
        parseQuantity(*wordsOf(question, option), quantity, BareNumber::refused, findUnit(quantity, "mm"));
    const double scale = scalesOf(question.scenario).penetration;
    const auto shown = [&](double gap) {
        return isDimensional ? formatNumber(gap * scale * 1000) + " mm" : formatNumber(gap);
    };
    const double gap = typed.si / scale;
    if (!typed.valid())
        asked.problem = {option, typed.problem};
    else if (!(gap >= least && gap <= most))
        asked.problem = {option, isDimensional ? Message(translatable("must be from %1 to %2, d0 being %3"),
                                                         {shown(least), shown(most), shown(1)})
                                               : Message(translatable("must be from %1 to %2"),
                                                         {shown(least), shown(most)})};
    return gap;
}

AskedGap askedGap(const StudyQuestion& question) {
    AskedGap asked;
    const bool hasMean = wordsOf(question, "gap-mean") != nullptr;
    if (!wordsOf(question, "gap-deviation")) {
        if (hasMean)
            asked.problem = {
                "", translatable("--gap-mean needs --gap-deviation, how far gaps scatter about it"), true};
        return asked;
    }
    NormalGap normal;
    normal.deviation =
        readGap(question, "gap-deviation", NormalGap::leastDeviation, NormalGap::mostDeviation, asked);
    if (asked.problem) return asked;
    normal.mean =
        hasMean ? readGap(question, "gap-mean", 0, mostMean, asked) : groupsOf(question.scenario).delta;
    asked.normal = normal;
    return asked;
}

class GapAnswer : public StudyAnswer {
  public:
    explicit GapAnswer(GapStudy study, std::vector<GapSample> samples = {})
        : StudyAnswer(study.scenario), m_study(std::move(study)), m_samples(std::move(samples)) {}

    Message gap() const override {
        if (m_study.curve.isComplete()) return {};
        return {translatable("could not be solved at all gaps: %1"), {m_study.curve.reason}};
    }
    std::vector<Message> sentences(const ReadingStyle& style) const override {
        if (!m_study.curve.dependsOnGap) return {periodRemark(m_study, style)};
        const GapSpread& spread = m_study.spread(GapOutput::cor);
        const auto number = [&](double value) { return style.number(value, 4); };
        std::vector<Message> sentences{
            {m_study.normal
                 ? translatable("For 90 % of the scattered gaps, e is between %1 and %2; its mean is %3.")
                 : translatable("For 90 % of all gaps, e is between %1 and %2; its mean is %3."),
             {number(spread.quantiles.front().value), number(spread.quantiles.back().value),
              number(spread.mean.value)}}};
        if (Message remark = periodRemark(m_study, style); !remark.isEmpty())
            sentences.push_back(std::move(remark));
        else if (hasUnits(scenario()))
            sentences.push_back({translatable("Results repeat every d₀ = %1 of gap."),
                                 {style.quantity(scalesOf(scenario()).penetration, Quantity::length, 4)}});
        else
            sentences.push_back(translatable("Results repeat every d₀ of gap."));
        return sentences;
    }
    StudyFigure figure(std::size_t view) const override {
        const auto output = static_cast<GapOutput>(view);
        return m_study.curve.isComplete() ? gapFigure(m_study, output)
                                          : gapPreviewFigure(scenario(), m_samples, output);
    }
    // In the period: beyond it everything repeats.
    std::optional<FigurePoint> placeOf(const Scenario& scenario, std::size_t view) const override {
        const GapCurve& curve = m_study.curve;
        double gap = groupsOf(scenario).delta;
        if (!curve.isComplete() || gap < curve.start) return std::nullopt;
        if (gap >= curve.end) gap = curve.periodStart + (gap - std::floor(gap));
        return FigurePoint{gap, curve.value(static_cast<GapOutput>(view), gap)};
    }
    std::optional<FigureSeries> overlay(std::size_t view, double until) const override {
        const GapCurve& curve = m_study.curve;
        if (!curve.isComplete()) return std::nullopt;
        const std::vector<double> gaps = sampleGaps(curve);
        FigureSeries series;
        const int periods = curve.dependsOnGap && curve.end > curve.periodStart ? mostPeriods : 1;
        for (int period = 0; period < periods; ++period)
            for (const double gap : gaps) {
                if (period > 0 && gap < curve.periodStart) continue;
                if (gap + period > until) return series;
                series.x.push_back(gap + period);
                series.y.push_back(curve.value(static_cast<GapOutput>(view), gap));
            }
        return series;
    }
    std::string text(const ReadingStyle& style) const override { return gapText(m_study, style); }
    std::string json(const std::string& scenarioText) const override {
        return gapJson(m_study, scenarioText);
    }
    std::string csv(OutputUnits units) const override { return gapCsv(m_study, units); }

  private:
    GapStudy m_study;
    std::vector<GapSample> m_samples;  // of a first look
};

StudyAnswerPtr run(const StudyQuestion& question, const StudyWork& work) {
    const std::optional<NormalGap> normal = askedGap(question).normal;
    const auto show = [&](const std::vector<GapSample>& samples) {
        work.show(std::make_shared<const GapAnswer>(
            GapStudy{
                .scenario = question.scenario, .curve = {}, .normal = normal, .statistics = {}, .runTime = 0},
            samples));
    };
    if (work.show) previewGaps(question.scenario, work.stop, show);
    return std::make_shared<const GapAnswer>(studyGap(question.scenario, normal, work.stop, work.progress));
}

constexpr StudyGroup scatter{
    .key = "scatter",
    .label = translatable("gap"),
    .name = translatable("How the gap scatters"),
    .tip = translatable("The gap at the rig is a matter of chance: all gaps of a period equally likely, or a "
                        "normal distribution cut off at zero"),
    .without = translatable("all equally likely"),
    .with = translatable("mean ± deviation")};

/// The gap of the scenario, then a tenth of a period.
constexpr auto presentGap = [](const Scenario& scenario) {
    return hasUnits(scenario) ? scenario.bitRock.gap : scenario.groups.delta;
};

double shareOfPeriod(const Scenario& scenario, double share) {
    return share * scalesOf(scenario).penetration;
}

}  // namespace

const Study& gapStudy() {
    static const QuantityControl mean{
        .like = "bit_rock.gap", .proposed = presentGap, .step = [](const Scenario& scenario) {
            return shareOfPeriod(scenario, 0.01);
        }};
    static const QuantityControl deviation{
        .like = "bit_rock.gap",
        .proposed = [](const Scenario& scenario) { return shareOfPeriod(scenario, 0.1); },
        .step = mean.step};
    static const Study study{
        .name = "gap",
        .title = translatable("COR–gap"),
        .plotTitle = translatable("Result over the gap, and how its values are distributed"),
        .summary = "restitution, forces and efficiency for all gaps between bit and rock",
        .details =
            "Prints how the results depend on the gap between bit and rock at the start of the blow. "
            "Nobody\ncontrols this gap at the rig. The results repeat each time the gap grows by d0 = 2 I0/Z "
            "(I0:\nimpulse of the blow, Z: impedance of the rod). All gaps within d0 therefore count as "
            "equally\nlikely. Prints minima and maxima with their gaps, mean, and 5, 50 and 95 % quantiles. "
            "Also prints\nthe share of gaps with a coefficient of restitution e above 1. --gap-deviation "
            "adds the same for a\nnormally distributed gap, cut off below zero.",
        .csvHelp = "also write the results at each gap to FILE.csv; -o - prints them instead of the table",
        .options = {{.key = "gap-mean",
                     .value = "GAP",
                     .help = "mean of a normally distributed gap, such as 0.5mm (default: the gap of FILE); "
                             "if FILE has no physical units, a multiple of d0, such as 0.2",
                     .control = mean,
                     .label = translatable("mean"),
                     .name = translatable("mean of the gap"),
                     .group = &scatter},
                    {.key = "gap-deviation",
                     .value = "GAP",
                     .help = "also print results for a normally distributed gap with this standard deviation",
                     .control = deviation,
                     .label = "±",
                     .name = translatable("standard deviation of the gap"),
                     .group = &scatter}},
        .views = {translatable("COR e"), translatable("peak force Fm"), translatable("efficiency")},
        .firstLook = translatable("A first look; the curve follows."),
        .clickHelp = translatable("Click on the curve to use that gap; Shift+click pins it."),
        .hasSi = true,
        .whyNot = whyNoPeriod,
        .elsewhere =
            translatable("COR–gap needs a uniform rod, whose results repeat over the gap. For drill strings "
                         "they do not repeat: Efficiency–stiffness shows them over the gap, point by point."),
        .isElsewhereOverGap = true,
        .reduce = [](Scenario& scenario) { findParameter("delta")->assign(scenario, 0); },
        .problem = [](const StudyQuestion& question) { return askedGap(question).problem; },
        .run = run,
    };
    return study;
}

}  // namespace drillwave
