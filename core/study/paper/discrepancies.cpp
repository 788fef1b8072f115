// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/paper/discrepancies.h"

#include <array>
#include <cmath>

#include "core/blow/impact_summary.h"
#include "core/model/scales.h"
#include "core/numeric/brent.h"
#include "core/study/gap/gap_statistics.h"
#include "core/study/paper/paper_case.h"
#include "core/text/csv.h"
#include "core/text/handy_text.h"
#include "core/text/units.h"
#include "core/wave/closed/closed_form.h"
#include "core/wave/field/bit_history.h"

namespace drillwave {

namespace {

using List = std::vector<Discrepancy>;

std::string shown(double value, int digits = 7) {
    return rounded(value, digits);
}

double workRatio(double tau) {
    Groups groups = paperElastic;
    groups.tau = tau;
    return summarize(solvePaperCase(groups, Detail::summary), paperProblem(groups)).workRatio;
}

/// d0 = 2 I0/Z of a rod of 1 m with c = 5000 m/s that arrives with 1 m/s [mm].
double imaginedPeriod() {
    Scenario scenario;
    scenario.rod.length = 1;
    scenario.rod.density = 8000;
    scenario.rod.youngsModulus = scenario.rod.density * 5000.0 * 5000.0;
    scenario.pulse.impulse = propertiesOf(scenario.rod).mass * 1.0;
    return scalesOf(scenario).penetration * 1000;
}

void addClosedForm(List& list) {
    const std::string place = "section 5.2";
    constexpr double stiff = 2;  // above beta1
    list.push_back({place, "beta1, root of exp(x) = 2x + 1", "1.2564", secondPulseEnd(stiff) * stiff, ""});
    const Impact impact = solvePaperCase(paperElastic, Detail::histories);
    const double first = impactImpulse(impact, 2 * paperElastic.tau);
    list.push_back({place, "I1, impulse of the first peak at beta = 0.5, tau = 10", "2", first,
                    "its tail is still " + shown(2 - first, 2) + " short of 2 when the next wave arrives"});
    list.push_back({place, "momentum after the first peak", "-1", 1 - first, "as above"});
}

void addWork(List& list) {
    list.push_back({"section 6", "W/W0 at tau = 10", "20", workRatio(paperElastic.tau), ""});
    list.push_back({"section 6", "W/W0 at tau = 1/2", "1", workRatio(0.5), ""});
}

void addFigure6(List& list) {
    const std::string place = "section 6, Fig. 6";
    const BetaExtreme top = extremeOverBeta([](double beta) { return corAtBeta(beta); }, 1);
    list.push_back({place, "largest e, gamma = 1", "1.414", top.cor, ""});
    list.push_back({place, "beta of the largest e", "0.300", top.beta, "e is flat there"});
    const auto reference = [](ReferenceStiffness stiffness) {
        return [stiffness](double beta) { return referenceCor(beta, 1, stiffness); };
    };
    const BetaExtreme low = extremeOverBeta(reference(ReferenceStiffness::roundTrip), -1);
    const BetaExtreme other = extremeOverBeta(reference(ReferenceStiffness::pulse), -1);
    list.push_back({place, "smallest e of the reference case, gamma = 1", "0.971", low.cor,
                    "with either normalisation"});
    list.push_back({place, "beta of it, k0 = Z/(2T)", "2.6", low.beta,
                    "the reference curves of the paper are drawn with k0 = Z/(2T), that is tau = 1/2"});
    list.push_back({place, "beta of it, k0 = Z/t0", "2.6", other.beta,
                    "with k0 = Z/t0, as section 5.1 defines it, and tau = 10 the minimum is elsewhere"});
    list.push_back({place, "e of the reference case at beta = 2.6, k0 = Z/t0", "0.971",
                    referenceCor(2.6, 1, ReferenceStiffness::pulse), "as above"});
    list.push_back({"section 6", "e of the reference case, gamma = 0.1, beta to 0", "0.316",
                    referenceCor(1e-6, 0.1, ReferenceStiffness::roundTrip), "sqrt(gamma)"});
    list.push_back({"section 6", "e, gamma = 0.1, large beta", "1", corAtBeta(1e7, 0.1), "at beta = 1e7"});
}

/// Where closed form and exact solution come apart by 0.001, which is about the width of a line in Fig. 7.
double betaOfVisibleOverlap() {
    constexpr double visible = 1e-3;
    const auto excess = [](double beta) { return closedFormRestitution(beta) - corAtBeta(beta) - visible; };
    return brentRoot(excess, 0.1, excess(0.1), 1, excess(1));
}

void addFigure7(List& list) {
    constexpr double soft = 1e-9, longRod = 1000;
    const BetaExtreme top = extremeOverBeta([](double beta) { return corAtBeta(beta); }, 1);
    const BetaExtreme farTop = extremeOverBeta([](double beta) { return corAtBeta(beta, 1, longRod); }, 1);
    list.push_back({"section 6, Fig. 7", "beta from which on the closed form is valid", "0.4",
                    betaOfVisibleOverlap(),
                    "where it is off by 0.001, a line's width; at 0.4 it is off by " +
                        shown(closedFormRestitution(0.4) - corAtBeta(0.4), 2)});
    list.push_back({"section 6, Fig. 7", "4 exp(-1/2) - 1, closed form for beta to 0", "1.4261",
                    closedFormRestitution(soft), ""});
    list.push_back({"abstract", "e up to", "1.4261", farTop.cor,
                    "a limit for long rods: the largest e is " + shown(top.cor) + " at tau = 10 and " +
                        shown(farTop.cor) + " at tau = 1000, the value computed here"});
}

/// The paper's Fig. 8 with another rod.
GapStatistics elasticGap(double tau) {
    Groups groups = paperElastic;
    groups.tau = tau;
    return gapStatistics(gapCurve(paperProblem(groups), Detail::cor));
}

double corAtGap(double gap) {
    Groups groups = paperElastic;
    groups.delta = gap;
    return paperCor(groups);
}

/// Where e of the blow passes e of the reference case, in a part of the period.
double referenceCrossing(double from, double to) {
    const double reference = referenceCor(paperElastic.beta, 1, ReferenceStiffness::roundTrip);
    const auto excess = [&](double gap) { return corAtGap(gap) - reference; };
    return brentRoot(excess, from, excess(from), to, excess(to));
}

void addFigure8(List& list) {
    const std::string place = "section 6, Fig. 8";
    const GapStatistics gap = elasticGap(paperElastic.tau), shorter = elasticGap(5);
    const GapExtreme& top = gap.of(GapOutput::cor).largest;
    const GapExtreme& low = gap.of(GapOutput::cor).least;
    const GapExtreme& lowShorter = shorter.of(GapOutput::cor).least;
    list.push_back({place, "largest e, gamma = 1", "1.393", top.value.value,
                    "at a cusp: already " + shown(corAtGap(0.005), 5) +
                        " at delta = 0.005; the closed form has " + shown(closedFormRestitution(0.5)) +
                        "; the printed value is that of tau = 5, " +
                        shown(shorter.of(GapOutput::cor).largest.value.value, 5)});
    list.push_back({place, "smallest e, gamma = 1", "0.844", low.value.value,
                    "at tau = 5 it is " + shown(lowShorter.value.value, 5)});
    list.push_back({place, "frac(delta) of the smallest e", "0.521", low.gap.value,
                    "at tau = 5 it is " + shown(lowShorter.gap.value, 5)});
    list.push_back({place, "e of the reference case, gamma = 1", "1.00",
                    referenceCor(paperElastic.beta, 1, ReferenceStiffness::roundTrip),
                    "k0 = Z/(2T); with k0 = Z/t0 it is " +
                        shown(referenceCor(paperElastic.beta, 1, ReferenceStiffness::pulse), 5)});
    for (const GapCrossing& crossing : gap.crossings)
        list.push_back(
            {place,
             std::string("frac(delta) where e ") + (crossing.rising ? "rises above" : "falls below") + " 1",
             crossing.rising ? "0.78" : "0.33", crossing.gap.value, ""});
    list.push_back({place, "frac(delta) where e falls below the reference case", "0.33",
                    referenceCrossing(0, low.gap.value), "k0 = Z/(2T)"});
    list.push_back({place, "frac(delta) where e rises above the reference case", "0.78",
                    referenceCrossing(low.gap.value, 1), "k0 = Z/(2T)"});
    list.push_back({place, "share of super rebounds", "0.55", gap.shareAboveOne.value, ""});
    list.push_back(
        {"section 6", "d0 for L = 1 m, c = 5000 m/s, v0 = 1 m/s [mm]", "0.4", imaginedPeriod(), ""});
}

void addThrust(List& list) {
    const BetaExtreme top = extremeOverBeta([](double beta) { return corAtBeta(beta); }, 1);
    const std::string why = "the largest over beta at no gap";
    list.push_back({"section 6", "e of an elastic bottom", "1.4", top.cor, why});
    list.push_back({"section 6", "I of an elastic bottom", "2.4", 1 + top.cor, why});
    list.push_back({"section 6", "thrust above that of a rigid bottom [percent]", "20",
                    ((1 + top.cor) / 2 - 1) * 100, "the paper rounds e to 1.4"});
}

}  // namespace

double Discrepancy::printedValue() const {
    return parseNumber(printed).value_or(std::numeric_limits<double>::quiet_NaN());
}

bool Discrepancy::agrees() const {
    const std::size_t point = printed.find('.');
    const auto decimals = point == std::string::npos ? 0 : static_cast<int>(printed.size() - point - 1);
    // a little more than half, for the rounding of the halves themselves
    return std::abs(difference()) <= 0.5000001 * std::pow(10, -decimals);
}

std::vector<Discrepancy> discrepancies(std::stop_token stop) {
    List list;
    for (void (*add)(List&) : {addClosedForm, addWork, addFigure6, addFigure7, addFigure8, addThrust})
        if (!stop.stop_requested()) add(list);
    return list;
}

std::string discrepanciesCsv(const std::vector<Discrepancy>& all) {
    std::string csv = "place,quantity,printed,computed,difference,agrees,explanation\n";
    for (const Discrepancy& one : all) {
        csv += csvCell(one.place) + "," + csvCell(one.quantity) + "," + one.printed + ",";
        appendNumber(csv, one.computed);
        csv += ',';
        appendNumber(csv, one.difference());
        csv += std::string(one.agrees() ? ",yes," : ",no,") + csvCell(one.explanation) + "\n";
    }
    return csv;
}

}  // namespace drillwave
