// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/paper/figures.h"

#include <array>
#include <cmath>
#include <functional>

#include "core/study/gap/gap_curve.h"
#include "core/study/paper/paper_case.h"
#include "core/wave/closed/closed_form.h"
#include "core/wave/field/bit_history.h"
#include "core/wave/field/rod_state.h"
#include "core/wave/field/wave_curves.h"
#include "core/wave/field/wave_field.h"

namespace drillwave {

namespace {

using Line = FigureCurve::Line;

/// How a curve is drawn.
struct Look {
    Line line = Line::solid;
    int colour = 0;
};

/// End of Fig. 4: four transit times.
const double lastTime = 4 * paperElastic.tau;

FigureCurve curve(std::string key, std::string label, const std::vector<double>& x,
                  const std::function<double(double)>& y, Look look = {}) {
    FigureCurve result{.key = std::move(key),
                       .label = std::move(label),
                       .x = x,
                       .y = {},
                       .line = look.line,
                       .colour = look.colour};
    for (const double at : x) result.y.push_back(y(at));
    return result;
}

std::vector<double> evenly(double from, double to, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(from + (to - from) * i / (count - 1));
    return values;
}

std::vector<double> betas() {
    std::vector<double> values;
    for (const double logarithm : evenly(std::log10(paperLeastBeta), std::log10(paperMostBeta), 401))
        values.push_back(std::pow(10, logarithm));
    values.front() = paperLeastBeta;
    values.back() = paperMostBeta;
    return values;
}

FigurePanel wavePanel(const char* name, const char* title, const Groups& groups) {
    FigurePanel panel{.name = name,
                      .title = title,
                      .xKey = "time",
                      .xLabel = "time t/t0",
                      .yKey = "normal_force",
                      .yLabel = "normal force N/F0, tension positive",
                      .xFrom = 0,
                      .curves = {}};
    constexpr std::array<const char*, 4> names{"N0p", "N1n", "N2p", "N3n"};
    const Impact impact = solvePaperCase(groups, Detail::histories);
    for (SectionWave& wave : sectionWaves(impact, 0.5, names.size())) {
        const char* key = names[static_cast<std::size_t>(wave.number)];
        FigureCurve drawn{.key = key, .label = key, .x = {}, .y = {}, .colour = wave.number};
        auto& [time, value] = wave.curve;
        // From nothing to its front, and not on to the front of the wave that follows.
        const double end = time.back() - 1e-9;
        while (time.size() > 1 && time[time.size() - 2] > end) {
            time.pop_back();
            value.pop_back();
        }
        drawn.x = {time.front()};
        drawn.y = {0};
        drawn.x.insert(drawn.x.end(), time.begin(), time.end());
        drawn.y.insert(drawn.y.end(), value.begin(), value.end());
        panel.curves.push_back(std::move(drawn));
    }
    return panel;
}

/// The history from the start of the hammer force on, of which sampleHistory() knows what happens at the
/// front end.
FigurePanel blowPanel(const char* name, const char* title, const Groups& groups) {
    FigurePanel panel{.name = name,
                      .title = title,
                      .xKey = "time",
                      .xLabel = "time t/t0",
                      .yKey = "value",
                      .yLabel = "force/F0, impulse/I0, momentum/I0",
                      .curves = {{.key = "impact_force", .label = "impact force F", .x = {}, .y = {}},
                                 {.key = "impulse", .label = "impulse of F", .x = {}, .y = {}, .colour = 1},
                                 {.key = "momentum", .label = "momentum p", .x = {}, .y = {}, .colour = 2}}};
    const PulseForce pulse = paperProblem(groups).force();
    const auto add = [&](double time, double force, double impulse) {
        const double values[] = {force, impulse, rodMomentum(pulse, time, impulse)};
        for (std::size_t i = 0; i < panel.curves.size(); ++i) {
            panel.curves[i].x.push_back(time);
            panel.curves[i].y.push_back(values[i]);
        }
    };
    const Impact impact = solvePaperCase(groups, Detail::histories);
    const SampledHistory history = sampleHistory(impact);
    add(0, 0, 0);
    add(pulse.end, 0, 0);
    for (std::size_t i = 0; i < history.time.size() && history.time[i] < lastTime; ++i)
        add(history.time[i], history.force[i], history.impulse[i]);
    const WaveField field(impact);
    add(lastTime, field.impactForce(lastTime), field.impactImpulse(lastTime));
    return panel;
}

FigurePanel peakPanel(const char* name, const char* title, const Impact& impact, double arrival, double end,
                      const std::function<double(double)>& closedForm) {
    const std::vector<double> times = evenly(0, end, 601);
    return {
        .name = name,
        .title = title,
        .xKey = "time",
        .xLabel = "time since the arrival of the wave, t/t0",
        .yKey = "impact_force",
        .yLabel = "impact force F/F0",
        .curves = {curve("exact", "exact", times, [&](double t) { return impactForce(impact, arrival + t); }),
                   curve("closed_form", "closed form", times, closedForm, {Line::dashed, 1})}};
}

FigurePanel corPanel(const char* name, const char* xKey, const char* xLabel) {
    return {.name = name,
            .title = {},
            .xKey = xKey,
            .xLabel = xLabel,
            .yKey = "cor",
            .yLabel = "coefficient of restitution e",
            .curves = {}};
}

/// The reference case, `beta` being that at each abscissa.
void addReferences(FigurePanel& panel, const std::vector<double>& x,
                   const std::function<double(double)>& beta) {
    const auto add = [&](const char* key, const char* label, double gamma, ReferenceStiffness stiffness,
                         Look look) {
        panel.curves.push_back(curve(
            key, label, x, [&](double at) { return referenceCor(beta(at), gamma, stiffness); }, look));
    };
    const auto paper = ReferenceStiffness::roundTrip, other = ReferenceStiffness::pulse;
    add("elastic_reference", "reference, gamma = 1, k0 = Z/2T", 1, paper, {Line::dotted, 0});
    add("bilinear_reference", "reference, gamma = 0.1, k0 = Z/2T", 0.1, paper, {Line::dotted, 1});
    add("elastic_reference_z_t0", "reference, gamma = 1, k0 = Z/t0", 1, other, {Line::dashed, 0});
    add("bilinear_reference_z_t0", "reference, gamma = 0.1, k0 = Z/t0", 0.1, other, {Line::dashed, 1});
}

FigureCurve alongGap(const char* key, const char* label, const Groups& groups,
                     const std::vector<double>& gaps, int colour) {
    const GapCurve cor = gapCurve(paperProblem(groups), Detail::cor);
    return curve(key, label, gaps, [&](double gap) { return cor.value(GapOutput::cor, gap); },
                 {Line::solid, colour});
}

}  // namespace

Figure figure3() {
    return {.number = 3,
            .caption = "Waves at the mid-section of the rod. beta = 0.5, tau = 10, delta = 0.",
            .panels = {wavePanel("fig3a", "(a) elastic, gamma = 1", paperElastic),
                       wavePanel("fig3b", "(b) bilinear, gamma = 0.1", paperBilinear)}};
}

Figure figure4() {
    return {.number = 4,
            .caption = "Impact force, its impulse, and momentum of the rod. beta = 0.5, tau = 10, delta = 0.",
            .panels = {blowPanel("fig4a", "(a) elastic, gamma = 1", paperElastic),
                       blowPanel("fig4b", "(b) bilinear, gamma = 0.1", paperBilinear)}};
}

Figure figure5() {
    const Impact impact = solvePaperCase(paperElastic, Detail::histories);
    const double beta = paperElastic.beta;
    return {.number = 5,
            .caption =
                "The peaks of the impact force beside the closed form. beta = 0.5, gamma = 1, tau = 10, "
                "delta = 0.",
            .panels = {peakPanel("fig5a", "(a) first peak F1", impact, 0, 12,
                                 [=](double t) { return firstForcePulse(beta, t); }),
                       peakPanel("fig5b", "(b) second peak F3", impact, 2 * paperElastic.tau, 2,
                                 [=](double t) { return secondForcePulse(beta, t); })}};
}

Figure figure6() {
    FigurePanel panel = corPanel("fig6", "beta", "spring stiffness beta");
    panel.logarithmicX = true;
    const std::vector<double> x = betas();
    panel.curves = {curve("elastic", "blow, gamma = 1", x, [](double beta) { return corAtBeta(beta); }),
                    curve("bilinear", "blow, gamma = 0.1", x,
                          [](double beta) { return corAtBeta(beta, 0.1); }, {Line::solid, 1})};
    addReferences(panel, x, [](double beta) { return beta; });
    return {.number = 6, .caption = "COR over the spring stiffness. tau = 10, delta = 0.", .panels = {panel}};
}

Figure figure7() {
    FigurePanel panel = corPanel("fig7", "beta", "spring stiffness beta");
    panel.logarithmicX = true;
    const std::vector<double> x = betas();
    const auto overlap = [](double beta) { return neglectedOverlap(beta, paperElastic.tau); };
    panel.curves = {curve("exact", "exact", x, [](double beta) { return corAtBeta(beta); }),
                    curve("closed_form", "closed form", x, closedFormRestitution, {Line::dashed, 1}),
                    curve("neglected_overlap", "neglected overlap", x, overlap, {Line::none})};
    return {
        .number = 7,
        .caption = "COR over the spring stiffness beside the closed form. gamma = 1, tau = 10, delta = 0.",
        .panels = {panel}};
}

Figure figure8() {
    FigurePanel panel = corPanel("fig8", "frac_delta", "gap frac(delta)");
    const std::vector<double> gaps = evenly(0, 1, 501);
    panel.curves = {alongGap("elastic", "blow, gamma = 1", paperElastic, gaps, 0),
                    alongGap("bilinear", "blow, gamma = 0.1", paperBilinear, gaps, 1)};
    addReferences(panel, gaps, [](double) { return paperElastic.beta; });
    return {
        .number = 8, .caption = "COR over one period of the gap. beta = 0.5, tau = 10.", .panels = {panel}};
}

Figure paperFigure(int number) {
    constexpr std::array make{figure3, figure4, figure5, figure6, figure7, figure8};
    return make.at(static_cast<std::size_t>(number - firstPaperFigure))();
}

std::vector<Figure> paperFigures(std::stop_token stop) {
    std::vector<Figure> figures;
    for (int number = firstPaperFigure; number <= lastPaperFigure; ++number) {
        if (stop.stop_requested()) break;
        figures.push_back(paperFigure(number));
    }
    return figures;
}

}  // namespace drillwave
