// SPDX-License-Identifier: GPL-3.0-or-later
// Study as a value: its options, question, computation and presentation. A command and a page are generated
// from it (app/study_command.h, ui/pages/study/figure_page.h).
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

/// Values of the options of a study as typed on the command line, by option name: {"gap-mean", "0.5 mm"}.
using StudyWords = std::map<std::string, std::string, std::less<>>;

/// Question for a study: a scenario with option values.
struct StudyQuestion {
    Scenario scenario;  ///< scenario from which all values without influence on the study are removed
    StudyWords words;
    bool operator==(const StudyQuestion&) const = default;
};

/// Reason why a study cannot be made with the given options, and the option that causes it.
struct StudyProblem {
    /// Option with the wrong value; empty if the scenario or a combination of options is the cause.
    std::string_view option;
    Message reason;
    bool isUsage = false;  ///< whether the options are incompatible; otherwise a value is out of range
};

/// Input field on the page for a number with a unit.
struct QuantityControl {
    /// Key of the parameter whose units the field uses. For a scenario without units, the field is a plain
    /// number.
    std::string_view like;
    double (*proposed)(const Scenario&);  ///< initial value, in SI units or as a plain number
    double (*step)(const Scenario&);      ///< size of a step from zero, in the same unit
};

/// Input on the page for a parameter range, "KEY=START:STOP[:log]": a list of the parameters that apply to
/// the scenario, and fields for both ends of the range.
struct RangeControl {
    /// Keys of the parameters at the top of the selection list. The first of them that applies to the
    /// scenario is selected initially.
    std::vector<std::string_view> preferred;
};

/// Control of an option that only the command line offers, not the page.
struct NoControl {};

/// Options that must be given together or not at all. A selection box on the page chooses between giving them
/// and leaving them out.
struct StudyGroup {
    std::string_view key;  ///< identifier of the selection box on the page
    const char* label;     ///< label in front of the box
    const char* name;      ///< accessible name for a screen reader
    const char* tip;
    const char* without;  ///< text of the initial choice of the selection box, which leaves all options out
    const char* with;
};

/// Option of a study. It appears as a row of the help, as an input on the page, and in the command that the
/// page can copy.
struct StudyOption {
    std::string_view key;    ///< name on the command line without dashes, such as "gap-mean"
    std::string_view value;  ///< placeholder of the option's value in the help, such as "GAP"
    std::string_view help;
    std::variant<NoControl, QuantityControl, RangeControl> control = NoControl{};
    const char* label = "";             ///< label in front of the input
    const char* name = "";              ///< accessible name for a screen reader
    const StudyGroup* group = nullptr;  ///< group of options that this option belongs to; nullptr for none
};

/// Axis of the parameter values for which a study writes CSV rows, with the name of the option that sets it.
struct StudyAxis {
    std::string_view option;
    SweepAxis axis;
};

/// Table of numbers below the figure of a study.
struct StudyTable {
    struct Title {
        Message text;
        Message tip;
    };
    struct Cell {
        std::string text;
        std::string more = {};  ///< more text, shown when the pointer is on the cell
    };
    std::vector<Title> columns = {};
    std::vector<Title> rows = {};
    std::vector<std::vector<Cell>> cells = {};  ///< cells of each row, indexed [row][column]
};

/// Result of a study, or a preview of it; immutable.
class StudyAnswer {
  public:
    explicit StudyAnswer(Scenario scenario) : m_scenario(std::move(scenario)) {}
    virtual ~StudyAnswer() = default;
    StudyAnswer(const StudyAnswer&) = delete;
    StudyAnswer& operator=(const StudyAnswer&) = delete;

    const Scenario& scenario() const { return m_scenario; }

    /// Returns why the result is incomplete, as a phrase that can follow a file name: "FILE: could not be
    /// solved …". Empty if it is complete.
    virtual Message gap() const = 0;
    /// Returns why some rows of csv() lack numbers, as a phrase that can follow a file name: "FILE: 3 of 50
    /// points could not be solved …". Empty if all rows are complete.
    virtual Message gapInRows() const { return {}; }
    /// Returns whether csv() has any rows. By default only a complete result has rows; a study may also
    /// return rows of an incomplete one.
    virtual bool hasRows() const { return gap().isEmpty(); }
    /// Returns the result in sentences. Requires a complete study; by default there are none.
    virtual std::vector<Message> sentences(const ReadingStyle& /*style*/) const { return {}; }
    /// Returns the figure for one of Study::views, given by its index; also available for a preview.
    virtual StudyFigure figure(std::size_t view) const = 0;
    /// Returns the point of the figure at which `scenario` is marked. It may differ from the scenario of the
    /// result only in the parameters on the axes. Empty if the point is outside the figure.
    virtual std::optional<FigurePoint> placeOf(const Scenario& /*scenario*/, std::size_t /*view*/) const {
        return std::nullopt;
    }
    /// Returns this result as a series, drawn for comparison over the figure of another scenario up to x =
    /// `until`. Without an override it is the first series of the figure.
    virtual std::optional<FigureSeries> overlay(std::size_t view, double until) const;
    /// Returns the point of the figure at which the blow of a pinned run (a run kept for comparison) is
    /// marked. Called only if Study::marksBlows is set. Empty if the figure has no such point.
    virtual std::optional<FigurePoint> placeOfBlow(const Blow& /*blow*/) const { return std::nullopt; }
    /// Returns the table of numbers that the page shows below the figure; empty by default.
    virtual StudyTable table(const ReadingStyle& /*style*/) const { return {}; }
    /// Returns the scenario that a click on a row of the table loads; empty if a click has no effect.
    virtual std::optional<Scenario> scenarioOfRow(std::size_t /*row*/) const { return std::nullopt; }
    /// Returns the result as text for a terminal: a table and notes.
    virtual std::string text(const ReadingStyle& style) const = 0;
    /// Returns the result as one JSON object. It contains `scenarioText`, the text of a scenario file, from
    /// which the result can be reproduced.
    virtual std::string json(const std::string& scenarioText) const = 0;
    /// Returns the rows of the result as CSV text with a header, dimensionless or in SI units.
    virtual std::string csv(OutputUnits units) const = 0;

  private:
    Scenario m_scenario;
};

using StudyAnswerPtr = std::shared_ptr<const StudyAnswer>;

/// Execution settings of a study: stop token, callbacks for progress (share done, 0 … 1) and for previews,
/// and number of threads.
struct StudyWork {
    std::stop_token stop = {};
    std::function<void(double share)> progress = [](double) {};
    std::function<void(StudyAnswerPtr)> show = nullptr;
    int threads = 1;
    WorkLimits limits = {};  ///< work limits of one blow
    bool isForText = true;   ///< whether text() or json() will be called, not only csv()
    /// Storage in which a study may keep intermediate results from one question to the next. Used by one
    /// thread at a time; nullptr for none.
    std::any* memory = nullptr;
};

/// Description of a study, from which its command and page are generated. Texts are in English and marked by
/// translatable().
struct Study {
    std::string_view name;     ///< name of the study's command, "gap"
    const char* title;         ///< title of the study's page in the window
    const char* plotTitle;     ///< name of the study's plot for a screen reader
    std::string_view summary;  ///< summary for the help, one line
    std::string_view details;  ///< text of the help that follows the summary
    std::string_view csvHelp;  ///< help text for -o, which describes the CSV
    std::vector<StudyOption> options;
    /// Names of the views of the study's figure, in the order of a selection box; empty if there is only one
    /// view.
    std::vector<const char*> views;
    const char* firstLook;  ///< sentence shown with a preview
    /// Sentence on the effect of a click on the figure, shown last among the sentences of the page.
    const char* clickHelp;
    bool hasSi;  ///< whether the CSV has the option --si

    /// Function that returns why a scenario cannot have this study, as a phrase that can follow a file name:
    /// "FILE: is …". The message is empty if the scenario can have the study.
    Message (*whyNot)(const Scenario& scenario);
    /// Text on the page if the scenario cannot have this study: the reason and, if there is one, the other
    /// page that has the result.
    const char* elsewhere;
    /// Whether `elsewhere` refers to the page Curve (tab COR–stiffness or Efficiency–stiffness). A button on
    /// the page then opens it with results over the gap.
    bool isElsewhereOverGap = false;
    /// Function that removes from a scenario the values that do not influence the result. Questions with the
    /// same result then compare equal.
    void (*reduce)(Scenario& scenario);
    /// Function that returns why a question cannot be answered although whyNot() accepts its scenario, for
    /// example because of a wrong option. Empty if it can be answered.
    std::optional<StudyProblem> (*problem)(const StudyQuestion& question);
    /// Returns the result of a question for which problem() is empty. After a stop request the result is
    /// incomplete (see StudyAnswer::gap()).
    StudyAnswerPtr (*run)(const StudyQuestion& question, const StudyWork& work);

    /// Whether the study requires physical units and its page shows values in them.
    bool isPhysical = false;
    /// Whether the study is about the feed force: its page is listed after those of single blows, and its
    /// command after `drill`.
    bool isOfFeed = false;
    /// Keys of optional parameters that the study needs. The page asks the user for those that the scenario
    /// lacks.
    std::vector<std::string_view> asked = {};
    /// Function that returns a message about which of the parameters in `asked` must still be entered. The
    /// message is empty if none is missing. nullptr if `asked` is empty.
    Message (*lacks)(const Scenario& scenario, const ReadingStyle& style) = nullptr;
    /// Function that returns the parameter axis whose values become the CSV rows; empty if the options of the
    /// question set none. nullptr if the study has no option for an axis.
    std::optional<StudyAxis> (*axis)(const StudyQuestion& question) = nullptr;
    std::string_view threadsHelp = {};  ///< help text for -j; empty if the study always uses all threads
    bool hasWorkLimit = false;          ///< whether the command has the option --work-limit
    /// Accessible name of the table on the page, for a screen reader; nullptr without a table.
    const char* tableName = nullptr;
    /// Whether pinned runs (runs kept for comparison) appear in the figure only as points, from
    /// placeOfBlow(). Otherwise the study is also computed for each pinned run.
    bool marksBlows = false;

    /// Returns the question of this study for a scenario and option values. Scenario values without influence
    /// on the result are removed by reduce(), so that questions with the same result compare equal.
    StudyQuestion question(Scenario scenario, StudyWords words) const;
};

/// Returns all studies that are described by a Study object, in the order in which commands and pages list
/// them. Defined in its own source file, so that a program can be linked with another list.
std::vector<const Study*> studies();

/// Returns the value typed for an option; nullptr if it was not given.
const std::string* wordsOf(const StudyQuestion& question, std::string_view option);

}  // namespace drillwave
