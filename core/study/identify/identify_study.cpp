// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/identify_study.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <random>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <boost/math/distributions/students_t.hpp>

#include "core/numeric/ordered_work.h"
#include "core/study/identify/even_samples.h"
#include "core/study/identify/known_sizes.h"

namespace drillwave {

namespace {

constexpr std::size_t leastRecordsOfScatter = 3;
constexpr std::size_t fewRecords = 5;
constexpr double widestDraws = 2.3;  ///< of a logarithm: a factor 10 says nothing

bool isGapKey(const std::string& key) {
    return key == "bit_rock.gap";
}

std::vector<GaugePlace> placesOf(const IdentifyQuestion& question, const GaugeRecord& record) {
    std::vector<GaugePlace> places;
    for (const GaugeChannel& gauge : record.gauges)
        if (auto place = gaugePlace(question.scenario, gauge.distance)) places.push_back(std::move(*place));
    return places;
}

/// A record and a blow in it.
struct BlowTask {
    std::size_t record = 0, blow = 0;
    RecordAnswer answer;
};

std::vector<BlowTask> tasksOf(const IdentifyQuestion& question) {
    std::vector<BlowTask> tasks;
    for (std::size_t r = 0; r < question.records.size(); ++r) {
        std::size_t blows = 1;
        const GaugeRecord& record = question.records[r];
        if (question.allBlows && record.time.size() > 1) {
            const EvenSamples even = evenSamples(record);
            blows = blowRanges(even.force.back(), even.step).size();
        }
        for (std::size_t b = 0; b < blows; ++b) tasks.push_back({r, b, {}});
    }
    return tasks;
}

/// The value of a parameter as it scatters: its logarithm, or the gap itself.
double scatteringValue(const IdentifiedParameter& parameter) {
    return parameter.isGap() ? parameter.value : std::log(parameter.value);
}

bool isTwoSided(const IdentifiedParameter& parameter) {
    return parameter.verdict == ParameterVerdict::identified ||
           parameter.verdict == ParameterVerdict::uncertain;
}

void findNextBlow(IdentifyFindings& findings) {
    std::vector<const RecordAnswer*> counted;
    for (const RecordAnswer& record : findings.records)
        if (!record.refusal && record.model != ModelVerdict::rejected && record.law != "file")
            counted.push_back(&record);
    if (findings.records.size() < 2 || counted.empty()) return;
    if (counted.size() < fewRecords) findings.remarks.emplace_back("few_records");
    for (const char* key : {"bit_rock.stiffness", "bit_rock.gamma", "bit_rock.gap"}) {
        std::vector<double> values, variances;
        double common = 0;
        for (const RecordAnswer* record : counted) {
            const IdentifiedParameter* parameter = record->find(key);
            if (!parameter || !(isTwoSided(*parameter) || parameter->isGap())) continue;
            const auto index = static_cast<std::size_t>(parameter - record->parameters.data());
            double shared = 0;
            for (const std::vector<double>& row : record->common) shared += row[index] * row[index];
            values.push_back(scatteringValue(*parameter));
            variances.push_back(std::max(0.0, parameter->halfWidth * parameter->halfWidth - shared) /
                                (half95 * half95));
            common += shared;
        }
        const std::size_t n = values.size();
        if (n < leastRecordsOfScatter) continue;
        common /= static_cast<double>(n);
        double mean = 0, own = 0, squares = 0;
        for (const double value : values) mean += value / static_cast<double>(n);
        for (const double variance : variances) own += variance / static_cast<double>(n);
        for (const double value : values) squares += (value - mean) * (value - mean);
        const double scatter = squares / static_cast<double>(n - 1);
        const boost::math::students_t distribution(static_cast<double>(n - 1));
        const double factor = boost::math::quantile(distribution, 0.975);
        const double width =
            std::hypot(factor * std::sqrt(scatter * (1 + 1 / static_cast<double>(n))), std::sqrt(common));
        NextBlowParameter next;
        next.key = key;
        const bool isGap = isGapKey(key);
        next.value = isGap ? mean : std::exp(mean);
        next.low = isGap ? std::max(0.0, mean - width) : std::exp(mean - width);
        next.high = isGap ? mean + width : std::exp(mean + width);
        next.scatter = std::sqrt(std::max(0.0, scatter - own));
        // χ² of n − 1 at 95 %, by Wilson and Hilferty
        const double degrees = static_cast<double>(n - 1);
        const double chi = std::pow(1 - 2 / (9 * degrees) + 1.645 * std::sqrt(2 / (9 * degrees)), 3);
        next.hasChange = scatter > own * chi;
        findings.nextBlow.push_back(std::move(next));
    }
}

/// Whether a row of values is a law that a scenario can hold.
bool isValidRow(const std::vector<std::string>& keys, const std::vector<double>& row, double gamma) {
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i] == "bit_rock.gamma") gamma = row[i];
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (keys[i] == "bit_rock.gamma" && !(row[i] > 0 && row[i] <= 1)) return false;
        if (keys[i] == "bit_rock.gap" && !(row[i] >= 0)) return false;
        if (keys[i] == "bit_rock.corner.1.slope" && !(row[i] > 0 && row[i] <= 1 / gamma)) return false;
        if (!std::isfinite(row[i])) return false;
    }
    return true;
}

}  // namespace

const RecordAnswer& IdentifyFindings::main() const {
    for (const RecordAnswer& record : records)
        if (!record.refusal && record.model != ModelVerdict::rejected) return record;
    for (const RecordAnswer& record : records)
        if (!record.refusal) return record;
    return records.front();
}

std::size_t IdentifyFindings::agreeingCount() const {
    return static_cast<std::size_t>(std::ranges::count_if(records, [](const RecordAnswer& record) {
        return !record.refusal && record.model != ModelVerdict::rejected;
    }));
}

bool IdentifyFindings::saysSomething() const {
    return std::any_of(records.begin(), records.end(),
                       [](const RecordAnswer& record) { return record.saysSomething(); });
}

std::vector<Message> identifyProblems(const IdentifyQuestion& question) {
    std::vector<Message> problems;
    for (const GaugeRecord& record : question.records) {
        const std::vector<GaugePlace> places = placesOf(question, record);
        if (places.size() != record.gauges.size()) {
            problems.emplace_back(translatable("a gauge is not on a uniform section of rod or string"));
            return problems;
        }
        for (Message& problem : knownProblems(question, places.front()))
            problems.push_back(std::move(problem));
        if (!problems.empty()) return problems;
    }
    return problems;
}

IdentifyFindings runIdentify(const IdentifyQuestion& question, int jobs, const std::stop_token& stop,
                             const TellIdentified& tell, const ShowAnswer& showFirst) {
    IdentifyFindings findings;
    std::vector<BlowTask> tasks = tasksOf(question);
    std::size_t next = 0;
    const WorkEnd end = processInOrder<BlowTask>(
        std::min<int>(jobs, static_cast<int>(tasks.size())), stop,
        [&](BlowTask& task) {
            if (next == tasks.size()) return false;
            task = tasks[next++];
            return true;
        },
        [&] {
            return [&](BlowTask& task, const std::stop_token& ending) {
                const GaugeRecord& record = question.records[task.record];
                task.answer = identifyRecord(question, record, placesOf(question, record), task.blow, ending,
                                             showFirst);
            };
        },
        [&](BlowTask& task) {
            findings.records.push_back(std::move(task.answer));
            if (tell) tell(findings);
            return true;
        });
    findings.isStopped = end == WorkEnd::stopped;
    if (!findings.isStopped) findNextBlow(findings);
    return findings;
}

std::optional<NextMeasurement> nextMeasurement(const RecordAnswer& answer) {
    if (answer.refusal || answer.model == ModelVerdict::rejected || answer.parameters.size() < 2)
        return std::nullopt;
    const IdentifiedParameter& stiffness = answer.parameters[0];
    const IdentifiedParameter& gamma = answer.parameters[1];
    struct Cause {
        std::string source, key, unit;
        double tolerance = 0, onStiffness = 0, onGamma = 0;
        double together() const { return std::hypot(onStiffness, onGamma); }
    };
    std::vector<Cause> causes{{"noise", "", "1", 0, stiffness.noise, gamma.noise}};
    for (std::size_t i = 0; i < stiffness.budget.size() && i < gamma.budget.size(); ++i) {
        const BudgetRow& row = stiffness.budget[i];
        causes.push_back({row.source, row.key, row.unit, row.tolerance, row.effect, gamma.budget[i].effect});
    }
    std::stable_sort(causes.begin(), causes.end(),
                     [](const Cause& a, const Cause& b) { return a.together() > b.together(); });
    if (!(causes.front().together() > 0)) return std::nullopt;
    constexpr double finest = 0.2;   // of today's tolerance
    constexpr double cheaper = 1.5;  // to measure a size than to change the set-up
    NextMeasurement best;
    double bestGain = -1;
    for (std::size_t i = 0; i < causes.size(); ++i) {
        const Cause& cause = causes[i];
        const double other = causes[i == 0 && causes.size() > 1 ? 1 : 0].together();
        const bool isMeasured = !cause.key.empty() && cause.tolerance > 0;
        double share = isMeasured && i > 0 ? finest : std::min(1.0, other / cause.together());
        if (cause.source == "noise") share = 0.5;  // the mean of four blows has half the noise
        NextMeasurement next{cause.source, cause.key, 0, cause.unit, "", 0};
        if (isMeasured) {
            const double wanted = cause.tolerance * std::max(share, finest);
            const double digit = std::pow(10, std::floor(std::log10(wanted)));
            next.tolerance = std::floor(wanted / digit + 1e-9) * digit;
            share = next.tolerance / cause.tolerance;
        }
        const double gain =
            cause.together() * cause.together() * (1 - share * share) * (isMeasured ? cheaper : 1);
        if (!(gain > bestGain)) continue;
        const bool isStiffness = cause.onStiffness >= cause.onGamma;
        const IdentifiedParameter& parameter = isStiffness ? stiffness : gamma;
        const double effect = isStiffness ? cause.onStiffness : cause.onGamma;
        next.parameter = parameter.key;
        next.halfWidth = std::sqrt(
            std::max(0.0, parameter.halfWidth * parameter.halfWidth - effect * effect * (1 - share * share)));
        best = next;
        bestGain = gain;
    }
    return best;
}

PosteriorDraws posteriorDraws(const IdentifyFindings& findings, std::size_t count, std::uint64_t seed) {
    PosteriorDraws draws;
    if (findings.records.empty() || findings.main().refusal) return draws;
    const RecordAnswer& answer = findings.main();
    if (answer.model == ModelVerdict::rejected || answer.law == "file") return draws;
    std::vector<std::size_t> used;
    bool isMainKnown = false;
    for (std::size_t i = 0; i < answer.parameters.size(); ++i) {
        const IdentifiedParameter& parameter = answer.parameters[i];
        if (!isTwoSided(parameter) || parameter.halfWidth > widestDraws) continue;
        used.push_back(i);
        isMainKnown = isMainKnown || i < 2;
    }
    if (!isMainKnown) return draws;
    const auto n = static_cast<Eigen::Index>(used.size());
    Eigen::VectorXd middle(n);
    Eigen::MatrixXd covariance(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const IdentifiedParameter& parameter = answer.parameters[used[static_cast<std::size_t>(i)]];
        draws.keys.push_back(parameter.key);
        middle[i] = scatteringValue(parameter);
        for (Eigen::Index j = 0; j < n; ++j)
            covariance(i, j) =
                answer.covariance[used[static_cast<std::size_t>(i)]][used[static_cast<std::size_t>(j)]];
    }
    for (Eigen::Index i = 0; i < n; ++i)
        for (const NextBlowParameter& next : findings.nextBlow) {
            if (next.key != draws.keys[static_cast<std::size_t>(i)]) continue;
            const bool isGap = isGapKey(next.key);
            middle[i] = isGap ? next.value : std::log(next.value);
            const double width = isGap ? next.high - next.value : std::log(next.high / next.value);
            const double wanted = width * width / (half95 * half95);
            const double scale = std::sqrt(wanted / covariance(i, i));
            covariance.row(i) *= scale;
            covariance.col(i) *= scale;
        }
    // The widened diagonal keeps it positive; a root of it by eigenvalues is safe anyway.
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
    const Eigen::MatrixXd root =
        solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
    const IdentifiedParameter* gamma = answer.find("bit_rock.gamma");
    std::mt19937_64 random(seed);
    constexpr std::size_t mostTries = 400;
    for (std::size_t tries = 0; draws.rows.size() < count && tries < mostTries * count; ++tries) {
        Eigen::VectorXd normal(n);
        for (Eigen::Index i = 0; i < n; ++i) normal[i] = standardNormal(random);
        const Eigen::VectorXd drawn = middle + root * normal;
        std::vector<double> row;
        for (Eigen::Index i = 0; i < n; ++i)
            row.push_back(isGapKey(draws.keys[static_cast<std::size_t>(i)]) ? drawn[i] : std::exp(drawn[i]));
        if (isValidRow(draws.keys, row, gamma ? gamma->value : 1)) draws.rows.push_back(std::move(row));
    }
    return draws;
}

Scenario identifiedScenario(const Scenario& scenario, const IdentifyFindings& findings) {
    Scenario identified = scenario;
    const RecordAnswer& answer = findings.main();
    if (answer.law == "file" || answer.parameters.empty()) return identified;
    // five digits: more would be noise, and a file is read by people
    const auto shortened = [](double value) {
        if (!(value > 0)) return 0.0;
        char digits[32];
        const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 5);
        std::from_chars(digits, end.ptr, value);
        return value;
    };
    const auto valueOf = [&](const char* key) {
        for (const NextBlowParameter& next : findings.nextBlow)
            if (next.key == key) return shortened(next.value);
        return shortened(answer.find(key)->value);
    };
    BitRock rock;
    rock.stiffness = valueOf("bit_rock.stiffness");
    rock.gamma = valueOf("bit_rock.gamma");
    rock.gap = valueOf("bit_rock.gap");
    if (answer.law == "corner") {
        rock.law = RockLaw::corners;
        RockCorner corner;
        corner.force = valueOf("bit_rock.corner.1.force");
        corner.slope = std::min(valueOf("bit_rock.corner.1.slope"), 1 / rock.gamma);
        rock.corners.push_back(corner);
    }
    identified.bitRock = rock;
    return identified;
}

std::vector<AssumedTolerance> assumedTolerances(const Scenario& scenario, const GaugePlace& place) {
    IdentifyQuestion question;
    question.scenario = scenario;
    std::vector<AssumedTolerance> all{{"gain", Quantity::ratio, std::nullopt},
                                      {"zero", Quantity::ratio, std::nullopt},
                                      {"gauge", Quantity::length, placeTolerance(question)}};
    for (const KnownSize& size : knownSizes(question, place))
        all.push_back({size.key, size.unit == "m^2" ? Quantity::area : Quantity::length, size.tolerance});
    return all;
}

}  // namespace drillwave
