// SPDX-License-Identifier: GPL-3.0-or-later
// Coverage of identifications over random rigs and troubles: identify_scenes [--seed S] [--count N]
// [--detail] [KIND …] Without KIND all of them. Prints for each how many records are refused, rejected and
// identified, and how many intervals hold the truth; then each interval that misses, with the seed that makes
// it again.
// identify_scenes --coverage [--seed S] [--count N] [COLOUR …] prints how many 95 % intervals hold the truth
// over nine rocks, three noise levels and N seeds, the sizes being exact, and the largest bias of one of
// them.
#include <cstdio>
#include <cstdlib>
#include <map>

#include "tests/core/study/identify/coverage_scenes.h"

using namespace drillwave;

namespace {

struct Tally {
    int records = 0, refused = 0, rejected = 0, identified = 0, intervals[3] = {0, 0, 0}, held[3] = {0, 0, 0};
    double worst = 0;  ///< |error| over half-width
    std::vector<double> widths[2];
    double seconds = 0;
};

double medianOf(std::vector<double> values) {
    if (values.empty()) return NAN;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

void judge(const GaugeScene& scene, const RecordAnswer& answer, std::uint64_t seed, Tally& tally) {
    ++tally.records;
    if (answer.refusal) {
        ++tally.refused;
        if (scene.mustIdentify)
            std::printf("   %s seed %llu refused: %s\n", scene.kind.c_str(),
                        static_cast<unsigned long long>(seed), answer.refusal->text.text().c_str());
        return;
    }
    if (answer.model == ModelVerdict::rejected) {
        ++tally.rejected;
        if (scene.mustIdentify)
            std::printf("   %s seed %llu rejected: m %.2f %% A %.1f %% q %.2f\n", scene.kind.c_str(),
                        static_cast<unsigned long long>(seed), 100 * answer.match.misfit,
                        100 * answer.match.unexplained, answer.match.ratio);
        return;
    }
    const double truths[] = {scene.stiffness, scene.gamma, scene.gap};
    bool isIdentified = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const IdentifiedParameter& parameter = answer.parameters[i];
        const bool isTwoSided = parameter.verdict == ParameterVerdict::identified ||
                                parameter.verdict == ParameterVerdict::uncertain;
        if (i == 0) isIdentified = parameter.verdict == ParameterVerdict::identified;
        if (i < 2 && isTwoSided) tally.widths[i].push_back(parameter.halfWidth);
        if (!isTwoSided || std::isnan(truths[i])) continue;
        ++tally.intervals[i];
        const double error = i == 2 ? parameter.value - truths[i] : std::log(parameter.value / truths[i]);
        const double ratio = std::abs(error) / parameter.halfWidth;
        if (ratio <= 1) {
            ++tally.held[i];
            continue;
        }
        tally.worst = std::max(tally.worst, ratio);
        std::printf(
            "   %s seed %llu: %s %.5g for %.5g, error %.2f half-widths of %.3g (%s; m %.2f %% A %.1f %%)",
            scene.kind.c_str(), static_cast<unsigned long long>(seed), parameter.key.c_str(), parameter.value,
            truths[i], ratio, parameter.halfWidth, answer.law.c_str(), 100 * answer.match.misfit,
            100 * answer.match.unexplained);
        for (const std::string& remark : answer.remarks) std::printf(" %s", remark.c_str());
        std::printf("\n");
    }
    if (isIdentified)
        ++tally.identified;
    else if (scene.mustIdentify)
        std::printf("   %s seed %llu not identified: k ± %.1f %% m %.2f %% A %.1f %%\n", scene.kind.c_str(),
                    static_cast<unsigned long long>(seed), 100 * answer.parameters[0].halfWidth,
                    100 * answer.match.misfit, 100 * answer.match.unexplained);
}

/// Everything about one answer.
void detail(const GaugeScene& scene, const RecordAnswer& answer) {
    if (answer.refusal) {
        std::printf("  refused: %s\n", answer.refusal->text.text().c_str());
        return;
    }
    const MatchFigures& match = answer.match;
    std::printf(
        "  %s %s m %.2f %% q %.2f noise %.2f (%.2f) %% quiet %.2f %% A %.2f %% before %.2f %% round trip "
        "%.1f of %.1f us\n",
        std::string(name(answer.model)).c_str(), answer.law.c_str(), 100 * match.misfit, match.ratio,
        100 * match.expected, 100 * match.noise, 100 * match.quiet, 100 * match.unexplained,
        100 * match.before, 1e6 * match.roundTrip, 1e6 * match.roundTripOfFile);
    std::printf("  truth %.4g %.4g %.4g; dispersion %.2f droop %.2f gain %.4f shift %.2f us", scene.stiffness,
                scene.gamma, scene.gap, match.dispersion.value_or(-1), match.droop, match.gainOfSecond,
                1e6 * match.shiftOfSecond);
    for (const ZeroLine95& zero : match.zero)
        std::printf(" zero %.2f %.2f %%", 100 * zero.offset, 100 * zero.slope);
    std::printf("\n");
    for (const IdentifiedParameter& parameter : answer.parameters) {
        std::printf("  %s %.5g ± %.3g %s noise %.3g:", parameter.key.c_str(), parameter.value,
                    parameter.halfWidth, std::string(name(parameter.verdict)).c_str(), parameter.noise);
        for (const BudgetRow& row : parameter.budget)
            if (row.effect > 0.1 * parameter.halfWidth)
                std::printf(" %s %.3g", row.source.c_str(), row.effect);
        std::printf("\n");
    }
    for (const TriedLaw& law : answer.laws) {
        std::printf("  %s m %.2f %% q %.2f:", law.law.c_str(), 100 * law.misfit, law.ratio);
        for (const auto& [key, value] : law.parameters) std::printf(" %.4g", value);
        std::printf("\n");
    }
    for (const std::string& remark : answer.remarks) std::printf("  %s", remark.c_str());
    if (answer.sizeOff) std::printf(" %s %.4g", answer.sizeOff->key.c_str(), answer.sizeOff->change);
    std::printf("\n");
    if (std::getenv("CURVES"))
        for (std::size_t i = 0; i < answer.curves.time.size(); ++i)
            std::printf("C %g %g %g %g %g\n", 1e6 * answer.curves.time[i], answer.curves.incident[i],
                        answer.curves.measured[i], answer.curves.model[i], answer.curves.residual[i]);
}

void print(const std::string& kind, const Tally& tally) {
    std::printf("%-18s %4d %7d %8d %10d", kind.c_str(), tally.records, tally.refused, tally.rejected,
                tally.identified);
    for (int i = 0; i < 3; ++i) std::printf("  %4d/%-4d", tally.held[i], tally.intervals[i]);
    std::printf(" %6.1f %6.1f  %5.2f %6.2f\n", 100 * medianOf(tally.widths[0]),
                100 * medianOf(tally.widths[1]), tally.worst, tally.seconds / std::max(1, tally.records));
    std::fflush(stdout);
}

/// Coverage of one colour of noise.
void printCoverage(const std::string& colour, int seeds, std::uint64_t first) {
    const CoverageTally tally = coverageOf(colour, seeds, first);
    std::printf("%-6s %4d records, %d silent", colour.c_str(), tally.records, tally.silent);
    const char* names[] = {"k", "gamma", "gap"};
    for (std::size_t i = 0; i < 3; ++i) {
        double worst = 0;
        std::string where;
        for (const auto& [cell, values] : tally.errors[i]) {
            double mean = 0;
            for (const double value : values) mean += value / static_cast<double>(values.size());
            if (std::abs(mean) <= std::abs(worst)) continue;
            worst = mean;
            where = cell;
        }
        std::printf("\n       %-5s %.1f %% of %d, bias %.2f, at most %.2f sd (%s)", names[i],
                    100 * tally.share(i), tally.intervals[i], tally.bias(i), worst, where.c_str());
    }
    std::printf("\n");
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    std::uint64_t seed = 1;
    int count = 10;
    std::vector<std::string> kinds;
    bool isDetailed = false, isCoverage = false;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--seed" && i + 1 < argc)
            seed = std::strtoull(argv[++i], nullptr, 10);
        else if (word == "--count" && i + 1 < argc)
            count = std::atoi(argv[++i]);
        else if (word == "--detail")
            isDetailed = true;
        else if (word == "--coverage")
            isCoverage = true;
        else
            kinds.push_back(word);
    }
    if (isCoverage) {
        if (kinds.empty()) kinds = {"white", "ar", "band", "slow", "tone"};
        for (const std::string& colour : kinds) printCoverage(colour, count, seed);
        return 0;
    }
    if (kinds.empty()) kinds = sceneKinds();
    std::vector<std::pair<std::string, Tally>> rows;
    Tally all;
    for (const std::string& kind : kinds) {
        Tally tally;
        for (int i = 0; i < count; ++i) {
            const std::uint64_t own = seed + static_cast<std::uint64_t>(i);
            const GaugeScene scene = sceneOf(kind, own);
            const auto start = std::chrono::steady_clock::now();
            const IdentifyFindings findings = runIdentify(scene.question);
            tally.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            if (isDetailed) detail(scene, findings.records.front());
            judge(scene, findings.records.front(), own, tally);
        }
        rows.emplace_back(kind, tally);
        print(kind, tally);
        all.records += tally.records;
        all.refused += tally.refused;
        all.rejected += tally.rejected;
        all.identified += tally.identified;
        for (int k = 0; k < 3; ++k) all.intervals[k] += tally.intervals[k], all.held[k] += tally.held[k];
        for (int k = 0; k < 2; ++k)
            all.widths[k].insert(all.widths[k].end(), tally.widths[k].begin(), tally.widths[k].end());
        all.worst = std::max(all.worst, tally.worst);
        all.seconds += tally.seconds;
    }
    std::printf(
        "\nkind             records refused rejected identified  k in       gamma in   gap in      ± k    ± "
        "γ  worst   s/record\n");
    for (const auto& [kind, tally] : rows) print(kind, tally);
    print("all", all);
}
