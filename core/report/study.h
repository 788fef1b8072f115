// SPDX-License-Identifier: GPL-3.0-or-later
// A study as a value: options, question, run and what is shown of its answer. The command and the page are
// made from it (app/study_command.h, ui/pages/study/figure_page.h).
#pragma once

#include <any>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/blow/method.h"
#include "core/model/scenario.h"
#include "core/report/figure.h"
#include "core/study/rows/output_column.h"
#include "core/study/rows/sweep_axis.h"
#include "core/text/handy_text.h"

namespace drillwave {

struct Blow;

/// Options that are given, each with its words of a command line: {"gap-mean", "0.5 mm"}.
using StudyWords = std::map<std::string, std::string, std::less<>>;

/// Scenario and options of a study.
struct StudyQuestion {
    Scenario scenario;  ///< without what does not matter to the study
    StudyWords words;
    bool operator==(const StudyQuestion&) const = default;
};

/// Why a question cannot be answered.
struct StudyProblem {
    std::string_view option;  ///< whose words are wrong; empty where it is the scenario or all options
    Message reason;
    bool isUsage = false;  ///< options that do not go together, rather than a value that is out of range
};

/// A field for a number with a unit.
struct QuantityControl {
    std::string_view like;                ///< key of the parameter whose units it has; of a scenario without
                                          ///< units it is a mere number
    double (*proposed)(const Scenario&);  ///< first value, in SI or as that number
    double (*step)(const Scenario&);      ///< size of a step from zero, in the same unit
};

/// A box of the parameters that apply to the scenario, with both ends of a range: KEY=START:STOP[:log].
struct RangeControl {
    std::vector<std::string_view> preferred;  ///< keys: the first that applies is offered first
};

/// No control on the page: only the command has the option.
struct NoControl {};

/// Options that are given together or not at all: a box on the page chooses.
struct StudyGroup {
    std::string_view key;  ///< name of the box
    const char* label;     ///< in front of it
    const char* name;      ///< for a screen reader
    const char* tip;
    const char* without;  ///< chosen at first: none of them is given
    const char* with;
};

/// One option: a row of the help, a control of the page, a word of the copied command.
struct StudyOption {
    std::string_view key;    ///< "gap-mean"
    std::string_view value;  ///< what it takes, for the help: "GAP"
    std::string_view help;
    std::variant<NoControl, QuantityControl, RangeControl> control = NoControl{};
    const char* label = "";             ///< before the control
    const char* name = "";              ///< for a screen reader
    const StudyGroup* group = nullptr;  ///< whose choice it belongs to
};

/// The axis of the rows that a study writes, and the option that gives it.
struct StudyAxis {
    std::string_view option;
    SweepAxis axis;
};

/// Numbers below a figure.
struct StudyTable {
    struct Title {
        Message text;
        Message tip;
    };
    struct Cell {
        std::string text;
        std::string more = {};  ///< shown with the text at the pointer
    };
    std::vector<Title> columns = {};
    std::vector<Title> rows = {};
    std::vector<std::vector<Cell>> cells = {};  ///< by rows
};

/// The result of a study, or a first look at it; it does not change once made.
class StudyAnswer {
  public:
    explicit StudyAnswer(Scenario scenario) : m_scenario(std::move(scenario)) {}
    virtual ~StudyAnswer() = default;
    StudyAnswer(const StudyAnswer&) = delete;
    StudyAnswer& operator=(const StudyAnswer&) = delete;

    const Scenario& scenario() const { return m_scenario; }

    /// Why it is not complete, in the words that follow "FILE: "; empty when it is.
    virtual Message gap() const = 0;
    /// Why rows lack numbers, in the same way; empty when none do.
    virtual Message gapInRows() const { return {}; }
    /// Whether there are rows, although there may be a gap().
    virtual bool hasRows() const { return gap().isEmpty(); }
    /// The answer in sentences, of a complete study (default: none).
    virtual std::vector<Message> sentences(const ReadingStyle& /*style*/) const { return {}; }
    /// One of Study::views; also of a first look.
    virtual StudyFigure figure(std::size_t view) const = 0;
    /// Where a scenario that differs in the parameters on the axes only is in that figure; nothing where it
    /// is outside.
    virtual std::optional<FigurePoint> placeOf(const Scenario& /*scenario*/, std::size_t /*view*/) const {
        return std::nullopt;
    }
    /// The series that is laid over the figure of another answer, up to a value of x (default: the first).
    virtual std::optional<FigureSeries> overlay(std::size_t view, double until) const;
    /// Where the blow of a pinned run is in the figure of Study::marksBlows.
    virtual std::optional<FigurePoint> placeOfBlow(const Blow& /*blow*/) const { return std::nullopt; }
    /// The numbers of Study::tableName.
    virtual StudyTable table(const ReadingStyle& /*style*/) const { return {}; }
    /// The scenario of a row of that table, which a click there loads; or nothing.
    virtual std::optional<Scenario> scenarioOfRow(std::size_t /*row*/) const { return std::nullopt; }
    /// Table and remarks for a terminal.
    virtual std::string text(const ReadingStyle& style) const = 0;
    /// One JSON object; the text gives the scenario again.
    virtual std::string json(const std::string& scenarioText) const = 0;
    /// Header and rows.
    virtual std::string csv(OutputUnits units) const = 0;

  private:
    Scenario m_scenario;
};

using StudyAnswerPtr = std::shared_ptr<const StudyAnswer>;

/// How a study works: with so many threads, until it is stopped; tells the share that is done (0 … 1) and
/// shows first looks to who wants them.
struct StudyWork {
    std::stop_token stop = {};
    std::function<void(double share)> progress = [](double) {};
    std::function<void(StudyAnswerPtr)> show = nullptr;
    int threads = 1;
    WorkLimits limits = {};      ///< of one blow
    bool isForText = true;       ///< whether text() or json() is asked for, not only the rows
    std::any* memory = nullptr;  ///< kept from question to question, for one thread at a time; or none
};

/// One study. Texts are in English and marked by translatable().
struct Study {
    std::string_view name;     ///< of its command
    const char* title;         ///< of its page
    const char* plotTitle;     ///< of its plot, for a screen reader
    std::string_view summary;  ///< one line of help
    std::string_view details;  ///< further help
    std::string_view csvHelp;  ///< what -o writes
    std::vector<StudyOption> options;
    std::vector<const char*> views;  ///< what its figure can show, in the order of a box; empty: one thing
    const char* firstLook;           ///< sentence while there is no more than that
    const char* clickHelp;           ///< what a click does, behind the sentences on the page
    bool hasSi;                      ///< whether the CSV has --si

    /// Why a scenario has no such study, in the words that follow "FILE: "; empty when it has.
    Message (*whyNot)(const Scenario& scenario);
    /// The same on the page, with where the answer is.
    const char* elsewhere;
    /// Whether the answer is on the page COR–stiffness with the gap as its parameter.
    bool isElsewhereOverGap = false;
    /// Takes out of a scenario what does not matter to the answer.
    void (*reduce)(Scenario& scenario);
    /// Returns the fault of a question whose scenario has the study, or nothing.
    std::optional<StudyProblem> (*problem)(const StudyQuestion& question);
    /// Answers a question without a problem. A stop leaves an answer with a gap().
    StudyAnswerPtr (*run)(const StudyQuestion& question, const StudyWork& work);

    /// Whether it is of scenarios with physical units, and shown in these.
    bool isPhysical = false;
    /// Whether its page stands behind those of single blows, and its command behind `drill`.
    bool isOfFeed = false;
    /// Keys of optional parameters: the page asks for those that the scenario lacks.
    std::vector<std::string_view> asked = {};
    /// Why there is no answer before these are given; nullptr where none are needed.
    Message (*lacks)(const Scenario& scenario, const ReadingStyle& style) = nullptr;
    /// The axis of the rows that are asked for; nullptr where rows need no axis.
    std::optional<StudyAxis> (*axis)(const StudyQuestion& question) = nullptr;
    std::string_view threadsHelp = {};  ///< of -j; empty: all threads are taken
    bool hasWorkLimit = false;          ///< whether the command has --work-limit
    const char* tableName = nullptr;    ///< of the table on the page, for a screen reader; or none
    bool marksBlows = false;            ///< whether pinned runs are only marked, without studies of their own

    /// The question about a scenario, which is reduced.
    StudyQuestion question(Scenario scenario, StudyWords words) const;
};

/// Returns all studies that are values, in the order of commands and pages. In a source of its own, so that a
/// program can have further ones.
std::vector<const Study*> studies();

/// The words of an option; nullptr where it is not given.
const std::string* wordsOf(const StudyQuestion& question, std::string_view option);

}  // namespace drillwave
