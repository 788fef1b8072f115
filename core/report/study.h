// SPDX-License-Identifier: GPL-3.0-or-later
// A study as a value: options, question, run and what is shown of its answer. The command and the page are
// made from it (app/study_command.h, ui/pages/study/figure_page.h).
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/model/scenario.h"
#include "core/report/figure.h"
#include "core/study/rows/output_column.h"
#include "core/text/handy_text.h"

namespace drillwave {

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
    /// The answer in sentences, of a complete study.
    virtual std::vector<Message> sentences(const ReadingStyle& style) const = 0;
    /// One of Study::views; also of a first look.
    virtual StudyFigure figure(std::size_t view) const = 0;
    /// Where a scenario that differs in the parameters on the axes only is in that figure; nothing where it
    /// is outside.
    virtual std::optional<FigurePoint> placeOf(const Scenario& scenario, std::size_t view) const = 0;
    /// The series that is laid over the figure of another answer, up to a value of x (default: the first).
    virtual std::optional<FigureSeries> overlay(std::size_t view, double until) const;
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
    /// Whether the answer is on the page COR–stiffness, over the gap.
    bool isElsewhereOverGap = false;
    /// Takes out of a scenario what does not matter to the answer.
    void (*reduce)(Scenario& scenario);
    /// Returns the fault of a question whose scenario has the study, or nothing.
    std::optional<StudyProblem> (*problem)(const StudyQuestion& question);
    /// Answers a question without a problem. A stop leaves an answer with a gap().
    StudyAnswerPtr (*run)(const StudyQuestion& question, const StudyWork& work);

    /// The question about a scenario, which is reduced.
    StudyQuestion question(Scenario scenario, StudyWords words) const;
};

/// Returns all studies that are values, in the order of commands and pages. In a source of its own, so that a
/// program can have further ones.
std::vector<const Study*> studies();

/// The words of an option; nullptr where it is not given.
const std::string* wordsOf(const StudyQuestion& question, std::string_view option);

}  // namespace drillwave
