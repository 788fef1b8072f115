// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of identifications on one thread: until the first answer, with all checks, and until a stop is obeyed:
// bench_identify [--csv | --json]
#include <atomic>
#include <chrono>
#include <cmath>
#include <string_view>
#include <thread>

#include "tests/bench/bench_table.h"
#include "tests/core/study/identify/coverage_scenes.h"

using namespace drillwave;
using namespace drillwave::bench;

namespace {

using Clock = std::chrono::steady_clock;
using Kind = Column::Kind;

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr CoverageRock rock{150e6, 0.2, 1e-4};

/// Longest wait from a stop to the end of an identification, stopped at `count` times spread over `length`.
double longestStop(const IdentifyQuestion& question, double length, int count) {
    double longest = 0;
    for (int i = 0; i < count; ++i) {
        std::stop_source stop;
        std::atomic<bool> isDone = false;
        std::thread work([&] {
            runIdentify(question, 1, stop.get_token());
            isDone = true;
        });
        std::this_thread::sleep_for(std::chrono::duration<double>(length * (i + 0.5) / count));
        const bool isRunning = !isDone;
        const Clock::time_point asked = Clock::now();
        stop.request_stop();
        work.join();
        if (isRunning) longest = std::max(longest, since(asked));
    }
    return longest;
}

void measure(Table& table, const char* name, const IdentifyQuestion& question, int stops) {
    const Clock::time_point start = Clock::now();
    std::atomic<double> first = std::nan("");
    runIdentify(question, 1, {}, {}, [&](RecordAnswer) {
        if (std::isnan(first)) first = since(start);
    });
    const double all = since(start);
    const double samples = static_cast<double>(question.records[0].time.size());
    table.add({name, static_cast<double>(question.records.size()), samples,
               std::isnan(first) ? all : first.load(), all,
               stops > 0 ? longestStop(question, all, stops) : std::nan("")});
}

/// The same record at so many times the rate.
IdentifyQuestion fineRecord(int samples) {
    IdentifyQuestion question = coverageScene("white", rock, 0.01, 1).question;
    GaugeRecord& record = question.records[0];
    const std::vector<double> coarse = record.gauges[0].force, times = record.time;
    const double step = (times.back() - times.front()) / (samples - 1);
    record.time.clear();
    record.gauges[0].force.clear();
    for (int i = 0; i < samples; ++i) {
        const double at = step * i / (times[1] - times[0]);
        const auto before = std::min(static_cast<std::size_t>(at), coarse.size() - 2);
        const double part = at - static_cast<double>(before);
        record.time.push_back(times.front() + step * i);
        record.gauges[0].force.push_back((1 - part) * coarse[before] + part * coarse[before + 1]);
    }
    return question;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view word = argc > 1 ? argv[1] : "";
    const Format format = word == "--csv" ? Format::csv : word == "--json" ? Format::json : Format::text;
    Table table(format, {{"scene", 30, Kind::word},
                         {"records", 8},
                         {"samples", 9},
                         {"first_s", 10, Kind::time},
                         {"all_s", 10, Kind::time},
                         {"stop_s", 10, Kind::time}});
    measure(table, "rod", coverageScene("white", rock, 0.01, 1).question, 10);
    measure(table, "string, bit head, two gauges", sceneOf("string", 2).question, 10);
    measure(table, "string, bit head, one gauge", sceneOf("string_one", 2).question, 0);
    measure(table, "corner", sceneOf("corner", 3).question, 10);
    measure(table, "crushing, then hardening", sceneOf("hardening", 3).question, 10);
    measure(table, "rod, 1e6 samples", fineRecord(1'000'000), 10);
    IdentifyQuestion hole;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        IdentifyQuestion one = coverageScene("white", rock, 0.01, seed).question;
        hole.scenario = one.scenario;
        hole.records.push_back(std::move(one.records[0]));
    }
    measure(table, "rod, a hole", hole, 0);
    return 0;
}
