// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever the program reads, mutated: each input is taken or refused, in bounded time, with words that fit
// on a line. fuzz_inputs --help; ctest tries some thousands, and an hour by hand some 10⁷.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <string_view>

#include "core/archive/kept_runs.h"
#include "core/archive/result_scenario.h"
#include "core/archive/row_record.h"
#include "core/blow/blow.h"
#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/report/blow_json.h"
#include "core/report/identify_report.h"
#include "core/report/signal_report.h"
#include "core/signal/signal_reading.h"
#include "core/study/design/draws.h"
#include "core/study/design/uncertain_input.h"
#include "core/study/identify/gauge_reading.h"
#include "core/study/rows/sweep_axis.h"
#include "core/study/rows/table.h"
#include "core/text/decimal_text.h"
#include "core/yaml/preset_file.h"
#include "core/yaml/pulse_reader.h"
#include "core/yaml/recorder_file.h"
#include "tests/core/study/identify/coverage_scenes.h"
#include "tests/support/mutation.h"
#include "tests/support/scenario_reading.h"

using namespace drillwave;
using namespace std::string_literals;
using namespace drillwave::test;

namespace {

constexpr const char* usage = R"(usage: fuzz_inputs [TARGET…] [--inputs N | --seconds S] [--seed S] [--from I]
  Mutates what each target reads (all of them without a name); prints how many were taken and the slowest.
  --inputs N   so many of each target (2000), fewer of slow ones
  --seconds S  as many as there is time for, of all targets
  --seed S     other mutations (1)
  --from I     from that one on: what an input was that did harm
)";

/// Requires a line for a reader. Its quotations are cleaned where they are printed.
void requireLine(const Message& message) {
    constexpr std::size_t longest = 4000;
    const std::string line = message.text();
    if (line.empty()) throw std::logic_error("refused without a word");
    if (line.size() > longest) throw std::logic_error("refused with a book: " + line);
}

template <class Line>
bool noneOf(const std::vector<Line>& lines) {
    std::ranges::for_each(lines, requireLine);
    return lines.empty();
}

/// Reads what may be refused by ScenarioError.
template <class Read>
bool isRead(Read read) {
    try {
        read();
        return true;
    } catch (const ScenarioError& error) {
        if (error.problems().empty()) throw std::logic_error("refused without a reason");
        noneOf(error.lines());
        return false;
    }
}

/// A folder that goes with the program.
class Folder {
  public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "fuzz_inputs.XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        m_path = name;
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string write(const std::string& name, const std::string& text) const {
        const std::filesystem::path path = m_path / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return path.string();
    }
    std::string path(const std::string& name) const { return (m_path / name).string(); }

  private:
    std::filesystem::path m_path;
};

const Folder& folder() {
    static const Folder one;
    return one;
}

Scenario defaultScenario() {
    return parseScenario(defaultExample().text, "").scenario;
}

std::vector<std::string> resultTexts() {
    std::vector<std::string> texts;
    for (const char* name : {"paper_fig4a", "t51_string"}) {
        const Example* example = findExample(name);
        if (!example) continue;
        const std::string text = completeScenarioText(parseScenario(example->text, ""));
        texts.push_back(blowJson(solveBlow(parseScenario(text, "").scenario, {}, Detail::summary), text));
        RowRecord record;
        record.command = "drillwave sweep " + std::string(name) + " --vary beta=1:2:3";
        record.method = MethodChoice{};
        record.rows = 3;
        record.axes = {{"beta", "1:2:3", 3}};
        record.outputs = {"cor"};
        record.scenario = text;
        texts.push_back(recordText(record));
        texts.emplace_back(example->text);
    }
    return texts;
}

std::vector<std::string> presetTexts() {
    return {
        "drillwave_presets: 1\nrods:\n- name: R25\n  area: [483 mm^2, a maker]\n"
        "  youngs_modulus: [210 GPa, steel]\n  density: [7850 kg/m^3, steel]\n",
        "drillwave_presets: 1\nrocks:\n- name: granite\n  stiffness: [300 MN/m, a book]\n  gamma: [0.1, a "
        "book]\n"
        "  law: [corners, a book]\n  corners: [[{force: 90 kN, slope: 0.35}], a book]\n",
        "drillwave_presets: 1\nhammers:\n- name: one\n  shape: [half_sine, assumed]\n"
        "  duration: [0.2 ms, assumed]\n  force: [200 kN, assumed]\n",
        "drillwave_presets: 1\ncouplings:\n- name: T38\n  source: a maker\n  sections:\n"
        "  - {length: 190 mm, diameter: 55 mm}\n"};
}

std::vector<std::string> tableTexts() {
    return {"beta,gamma\n0.5,0.1\n1,0.2\n",
            "rod.length [m],bit_rock.stiffness [MN/m],note\n3,300,a\n4.27,150,\"b, c\"\n",
            "scenario,pulse.shape,gap [um]\none,half_sine,0\ntwo,triangular,120\n",
            "bit_rock.gamma\tpulse.duration\n0.1\t200 us\n0.2\t0.1 ms\n",
            "rod.length [m];bit_rock.gamma\r\n3,66;0,1\r\n4,27;0,2\r\n;\r\n",
            "beta\n0,5\n0,7\n"};
}

std::vector<std::string> sampleTexts() {
    return {"time [us],force [kN]\n0,0\n10,120\n20,180\n30,90\n40,0\n",
            "# scope\nt;strain A;strain B\n0,000;1,5;1,25\n0,001;20,5;21\n0,002;7;6,5\n",
            "Rate 1 MHz\n0\n1\n5\n3\n-1\n",
            "\xEF\xBB\xBFtime (s)\tV\r\n0\t1e-3\r\n1e-6\t2e-3\r\n2e-6\t-1e-3\r\n",
            "x-axis,3\nsecond,Volt\n0,1\n1,2\n2,0\n",
            "Date;Time;Force "
            "[kN]\n2024-03-12;09:11:02.1;1,5\n2024-03-12;09:11:02.2;2,5\n2024-03-12;09:11:03.0;0\n",
            "\"Record Length\",3,\"Points\",0.0,1.5\r\r\n\"Sample "
            "Interval\",1e-6,s,1e-6,2.5\r\r\n,,,2e-6,9.9e37\r\r\n",
            "Tid [\u00b5s];Kraft [kN]\n\u22121;\u22120,5\n0;1\u00a0234,5\n1;#SAKNAS!\n2;1.234,5\n",
            "time [us],-2,-1,0,1,2,3,4,5,6,7\nforce [kN],0,1,2,3,2,1,0,0,0,0\n",
            "t [us],F [kN]\n0,1\n1,2\n2,1\n\0\0\0"s};
}

/// Records of a gauge on a rod, and of a pair of gauges, every fourth sample.
std::vector<std::string> gaugeTexts() {
    std::vector<std::string> texts;
    for (const bool isPair : {false, true}) {
        const GaugeScene scene = coverageScene("white", coverageRocks[4], 0.005, isPair ? 2 : 1);
        const GaugeRecord& record = scene.question.records[0];
        std::string text = isPair ? "time [us];A [kN];B [kN]\n" : "time [us],A [kN]\n";
        for (std::size_t i = 0; i < record.time.size(); i += 4) {
            const double force = 1e-3 * record.gauges[0].force[i];
            char line[80];
            if (isPair)
                std::snprintf(line, sizeof line, "%.0f;%.2f;%.2f\n", 1e6 * record.time[i], force + 2,
                              force - 2);
            else
                std::snprintf(line, sizeof line, "%.0f,%.2f\n", 1e6 * record.time[i], force);
            text += line;
        }
        texts.push_back(text);
    }
    return texts;
}

std::vector<std::string> wordTexts() {
    return {"bit_rock.stiffness=50MN/m:250MN/m:log",
            "rod.length=+-5%",
            "bit_rock.gamma=0.05:0.3",
            "beta=0.1:10:20:log",
            "pulse.shape=rectangular,half_sine",
            "gap=0,0.1 mm,120um",
            "pulse.duration=200 us",
            "string.3.length=3.66 m",
            "hammer.restrike=false",
            "drill.thrust=3.2kN:8kN:10"};
}

/// A reader of the program that is fed: texts to begin with, and whether one is taken. It throws where
/// something is wrong.
struct Target {
    std::string_view name;
    std::vector<std::string> corpus;
    std::function<bool(const std::string&)> takes;
    std::uint64_t cost = 1;  ///< one of so many inputs is tried
};

bool takesTable(const std::string& text) {
    static const Scenario base = defaultScenario();
    std::istringstream cases(text);
    Table table;
    table.base = base;
    table.source = "cases.csv";
    table.columns = chooseOutputs("cor", OutputUnits::si).columns;
    const TableCheck check = checkTable(table, cases, 1, {});
    noneOf(check.warnings);
    return noneOf(check.problems);
}

/// As records are read, with rows refused and skipped.
bool takesSamples(const std::string& text) {
    bool isTaken = false;
    for (const WrongRows wrongRows : {WrongRows::refused, WrongRows::skipped}) {
        SignalOptions options;
        options.wrongRows = wrongRows;
        std::istringstream in(text);
        const SignalReading reading = readSignal(in, options);
        for (const SignalRemark& remark : reading.remarks) requireLine(remark.text);
        if (!reading.problem.isEmpty()) {
            requireLine(reading.problem);
            continue;
        }
        const Samples& samples = reading.samples;
        if (samples.time.size() != samples.value.size()) throw std::logic_error("times without values");
        if (!std::ranges::is_sorted(samples.time)) throw std::logic_error("time goes back");
        if (!reading.isOpen() && reading.blow.points.empty())
            throw std::logic_error("no blow and no question");
        if (!reading.isTimeKnown() && !reading.isOpen())
            throw std::logic_error("a time is assumed in silence");
        if (!reading.unit && !reading.isOpen()) throw std::logic_error("a unit is assumed in silence");
        signalText({"record.csv", reading}, plainStyle());
        signalJson({"record.csv", reading});
        isTaken = true;
    }
    return isTaken;
}

/// As `identify` reads a record, with the answer in every form: numbers are finite, or there are none.
bool takesGaugeRecord(const std::string& text) {
    IdentifyReport report;
    report.question.scenario = rodScenario({});
    std::istringstream in(text);
    GaugeChoice gauge{.column = "A", .opposite = "", .distance = RodRig().ahead};
    if (text.find("B [kN]") != std::string::npos) gauge.opposite = "B";
    const GaugePlace place = *gaugePlace(report.question.scenario, gauge.distance);
    GaugeReading reading = readGauges(in, {}, {gauge}, {place});
    if (!reading.problem.isEmpty()) {
        requireLine(reading.problem);
        return false;
    }
    if (!reading.questions.empty()) return false;
    report.question.records.push_back(std::move(reading.record));
    report.findings = runIdentify(report.question);
    const RecordAnswer& answer = report.findings.main();
    requireLine(identifySentence(answer));
    identifyText(report, plainStyle());
    if (answer.refusal) {
        requireLine(answer.refusal->text);
        return false;
    }
    for (const IdentifiedParameter& parameter : answer.parameters)
        for (const double value : {parameter.value, parameter.low.value_or(0), parameter.high.value_or(0)})
            if (!std::isfinite(value)) throw std::logic_error("no number for " + parameter.key);
    if (matchCsv(report).find("nan") != std::string::npos) throw std::logic_error("no number in match.csv");
    posteriorCsv(report);
    return answer.model != ModelVerdict::rejected;
}

bool takesRecorders(const std::string& text) {
    const RecorderFile file = parseRecorders(text, "recorders.yaml");
    if (!noneOf(file.problems)) return false;
    if (parseRecorders(recorderText(file.recorders), "again").recorders != file.recorders)
        throw std::logic_error("written they are others");
    return true;
}

bool takesPulseTable(const std::string& text) {
    const PulseTable table =
        readPulseTable(folder().write("pulse.csv", text), "pulse.csv", ScenarioForm::dimensional);
    for (const InputProblem& problem : table.problems) requireLine(problem.text.text());
    return table.problems.empty();
}

bool takesDraws(const std::string& text) {
    std::istringstream in(text);
    const ReadDraws read = readDraws(in, "draws.csv");
    const bool isReadable = noneOf(read.unreadable);
    return noneOf(read.invalid) && isReadable;
}

bool takesRuns(const std::string& text) {
    folder().write("t38.runs/A.yaml", std::string(defaultExample().text));
    folder().write("t38.runs/runs.csv", text);
    return noneOf(readRuns(folder().path("t38.runs"), folder().path("t38.yaml")).problems);
}

std::string indexOfRuns() {
    KeptRun run;
    run.name = "k 300 MN/m";
    run.contents = parseScenario(defaultExample().text, "");
    run.cor = 0.25;
    return runFiles({run}).back().bytes;
}

bool takesAssignment(const std::string& text) {
    static const Scenario rod = defaultScenario();
    static const Scenario string = parseScenario(findExample("t51_string")->text, "").scenario;
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) return false;
    bool isTaken = false;
    for (Scenario scenario : {rod, string}) {
        const Message problem = assignText(scenario, std::string_view(text).substr(0, equals),
                                           std::string_view(text).substr(equals + 1));
        if (!problem.isEmpty()) {
            requireLine(problem);
            continue;
        }
        isTaken = true;
        for (const InputProblem& fault : validate(scenario)) requireLine(fault.text.text());
    }
    return isTaken;
}

bool takesQuantity(const std::string& text) {
    bool isTaken = false;
    for (const Parameter& parameter : parameters()) {
        const TypedQuantity typed = parseQuantity(text, parameter.quantity);
        if (!typed.valid()) {
            requireLine(typed.problem.text());
            continue;
        }
        isTaken = true;
        const std::string written = formatQuantity(typed.si, parameter.quantity, *typed.unit);
        if (parseQuantity(written, parameter.quantity).si != typed.si)
            throw std::logic_error("written it is another: " + written);
    }
    return isTaken;
}

template <class Parsed>
bool isWithoutProblem(const Parsed& parsed) {
    if (!parsed.problem.isEmpty()) requireLine(parsed.problem);
    return parsed.problem.isEmpty();
}

std::vector<Target> allTargets() {
    return {
        {"scenario", corpusOfTexts(), [](const std::string& text) { return readAndSaved(text); }},
        {"result", resultTexts(),
         [](const std::string& text) { return isRead([&] { parseInput(text, "result.json"); }); }},
        {"record", resultTexts(),
         [](const std::string& text) { return isRead([&] { parseRowPart(text, "rows.csv"); }); }},
        {"presets", presetTexts(),
         [](const std::string& text) { return isRead([&] { parsePresets(text, "presets.yaml"); }); }},
        {"runs", {indexOfRuns()}, takesRuns},
        {"table", tableTexts(), takesTable},
        {"draws", tableTexts(), takesDraws},
        {"pulse_table", sampleTexts(), takesPulseTable},
        {"samples", sampleTexts(), takesSamples},
        {"gauge_record", gaugeTexts(), takesGaugeRecord, 20},
        {"recorders",
         {"drillwave_recorders: 1\nrecorders:\n  \"rig scope\":\n    unit: \"V\"\n    scale: \"50kN/V\"\n    "
          "invert: true\n",
          "drillwave_recorders: 1\nrecorders:\n  a: {rate: 5MHz, zero: \"0us:10us\", rows: skip}\n  b: {}\n"},
         takesRecorders},
        {"axis", wordTexts(), [](const std::string& text) { return isWithoutProblem(parseAxis(text, 10)); }},
        {"uncertain", wordTexts(),
         [](const std::string& text) { return isWithoutProblem(parseUncertain(text)); }},
        {"assignment", wordTexts(), takesAssignment},
        {"quantity",
         {"38 mm", "1.5in", "255 kN", "200 us", "2 %", "30e6 psi", "7.8 g/cm^3", "-0", "1e308 km"},
         takesQuantity}};
}

struct Options {
    std::vector<std::string_view> targets;
    std::uint64_t inputs = 2000, seed = 1, from = 0;
    double seconds = 0;
};

/// The input of that number: the same whenever and wherever it is asked for.
std::string inputOf(const Target& target, std::uint64_t seed, std::uint64_t number) {
    Random random(seed * 1'000'000'007 + number);
    std::string text = target.corpus[number % target.corpus.size()];
    for (std::size_t n = 1 + below(number % 2 == 0 ? 1 : 6, random); n > 0; --n)
        mutate(text, target.corpus, random);
    return text;
}

char place[200];  ///< what is being read, should it be the last

void tellPlace(int signal) {
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, place, std::strlen(place));
    std::_Exit(128 + signal);
}

double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Tally {
    std::uint64_t inputs = 0, taken = 0;
    double slowest = 0;
};

/// One input; false where something is wrong with what came of it.
bool feed(const Target& target, const Options& options, std::uint64_t number, Tally& tally) {
    std::snprintf(place, sizeof place, "\nfuzz_inputs: ended by %.*s --seed %llu --from %llu --inputs 1\n",
                  int(target.name.size()), target.name.data(), static_cast<unsigned long long>(options.seed),
                  static_cast<unsigned long long>(number));
    const std::string text = inputOf(target, options.seed, number);
    constexpr unsigned longest = 20;
    ::alarm(longest);
    const double start = secondsNow();
    try {
        tally.taken += target.takes(text);
    } catch (const std::exception& error) {
        std::printf("%.*s --seed %llu --from %llu --inputs 1: %s\n%s\n", int(target.name.size()),
                    target.name.data(), static_cast<unsigned long long>(options.seed),
                    static_cast<unsigned long long>(number), error.what(), text.c_str());
        return false;
    }
    ::alarm(0);
    tally.slowest = std::max(tally.slowest, secondsNow() - start);
    ++tally.inputs;
    return true;
}

bool read(int argc, char** argv, const std::vector<Target>& targets, Options& options) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (!word.starts_with("--")) {
            if (std::ranges::find(targets, word, &Target::name) == targets.end()) return false;
            options.targets.push_back(word);
            continue;
        }
        const auto number = i + 1 < argc ? wholeNumberIn<std::uint64_t>(argv[++i]) : std::nullopt;
        if (!number) return false;
        if (word == "--inputs")
            options.inputs = *number;
        else if (word == "--seconds")
            options.seconds = double(*number);
        else if (word == "--seed")
            options.seed = *number;
        else if (word == "--from")
            options.from = *number;
        else
            return false;
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<Target> targets = allTargets();
    Options options;
    if (!read(argc, argv, targets, options)) {
        std::fputs(usage, stderr);
        std::fputs("targets:", stderr);
        for (const Target& target : targets)
            std::fprintf(stderr, " %.*s", int(target.name.size()), target.name.data());
        std::fputs("\n", stderr);
        return 2;
    }
    std::erase_if(targets, [&](const Target& target) {
        return !options.targets.empty() &&
               std::ranges::find(options.targets, target.name) == options.targets.end();
    });
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGALRM})
        std::signal(signal, tellPlace);
    bool isRight = true;
    std::printf("target         inputs   taken  slowest_ms\n");
    for (const Target& target : targets) {
        Tally tally;
        const double end = secondsNow() + options.seconds / double(targets.size());
        for (std::uint64_t i = options.from;
             options.seconds > 0
                 ? secondsNow() < end
                 : i < options.from + std::max<std::uint64_t>(1, options.inputs / target.cost);
             ++i)
            isRight &= feed(target, options, i, tally);
        std::printf("%-12.*s %8llu %7llu %11.2f\n", int(target.name.size()), target.name.data(),
                    static_cast<unsigned long long>(tally.inputs),
                    static_cast<unsigned long long>(tally.taken), 1e3 * tally.slowest);
        std::fflush(stdout);
    }
    return isRight ? 0 : 1;
}
