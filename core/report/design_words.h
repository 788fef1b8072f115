// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences about a design study.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/design_report.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// Source of the names of designs and objectives, and of numbers, in sentences about a design study. This
/// class uses the names of the command line. A subclass in the window replaces them by the names in its form.
class DesignNames {
  public:
    /// Stores references to the study and the style, which must outlive this object.
    explicit DesignNames(const DesignStudy& study, const ReadingStyle& style = plainStyle())
        : m_study(study), m_style(style) {}
    DesignNames(const DesignNames&) = delete;
    DesignNames& operator=(const DesignNames&) = delete;
    virtual ~DesignNames() = default;

    const ReadingStyle& style() const { return m_style; }
    /// Returns the name of a design (index from 0): the values of its design variables, such as "240 us, 3.05
    /// m".
    virtual std::string design(std::uint64_t design) const;
    /// Returns the name of one value of a design variable, such as "240 us".
    virtual std::string choiceValue(const SweepAxis& choice, double value) const;
    /// Returns the name of an objective, such as "efficiency q05".
    virtual Message aim(const DesignAim& aim) const;
    /// Returns the name of a design variable within a sentence: its key for the command line, or its label in
    /// print, such as "duration".
    virtual Message choice(const SweepAxis& choice) const;
    /// Returns the value of an output with its unit.
    virtual std::string value(const Output& output, double value, int digits) const;
    /// Returns the value of an objective for a design, with its error if it has one, such as "0.712 +-
    /// 0.001".
    virtual std::string aimed(const DesignReport& report, const DesignAim& aim, std::size_t design) const;

  private:
    const DesignStudy& m_study;
    const ReadingStyle& m_style;
};

/// Warning or note about the result of a design study.
struct DesignRemark {
    bool isWarning = false;
    std::string code;  ///< code for programs, such as "flat_optimum"
    Message text;
};
std::vector<DesignRemark> remarksOn(const DesignReport& report, const DesignNames& names);
std::vector<DesignRemark> remarksOn(const DesignReport& report, const ReadingStyle& style = plainStyle());

/// Result of a design study in one word. If designs are equally good in one objective, the next objective
/// decides.
enum class DesignHeadline {
    keep,          ///< no design is better than the present one
    change,        ///< a design is better than the present one, or the present one is not among the designs
    noDifference,  ///< all designs are feasible and equally good, within errors
    noneFeasible,  ///< no design satisfies the limits
};
/// Returns the name as in JSON: "keep", "change", "no_difference" or "none_feasible".
std::string_view name(DesignHeadline headline);
/// Returns the result of a design study in one word; empty with fewer than two designs.
std::optional<DesignHeadline> headlineOf(const DesignReport& report);
/// Returns the result of a design study as a sentence, such as "Keep the present design, …". Empty with fewer
/// than two designs, and if no design satisfies the limits.
Message designAnswerMessage(const DesignReport& report, const DesignNames& names);
/// Returns the first warning about the recommended design, followed by the number of further ones; empty
/// without warnings.
Message designWarning(const DesignReport& report, const DesignNames& names);
/// Returns the recommendation as a sentence, followed by the first warning about the recommended design.
/// Empty if there is neither.
Message headlineMessage(const DesignReport& report, const DesignNames& names);
Message headlineMessage(const DesignReport& report, const ReadingStyle& style = plainStyle());

/// Returns the marks of a design (index from 0): "best_uncertain", "best_nominal", "equal" (one of several
/// equally good designs) and "present". `present` must be the index from presentDesign().
std::vector<std::string_view> marksOf(const DesignReport& report, std::size_t design,
                                      std::optional<std::size_t> present);

/// Returns whether a study has enough samples for its Sobol indices to be meaningful.
bool carriesShares(const DesignStudy& study);

/// Returns which uncertain input is most worth measuring: the one with the largest total Sobol index for an
/// output (index `aimed` in DesignFindings::aimed). The result is an index in OutputSensitivity::indices.
/// Empty if the index is too uncertain or there is only one input.
std::optional<std::size_t> firstToMeasure(const DesignReport& report, std::size_t aimed);

/// Returns the value of an objective for a design (index from 0), such as the 5 % quantile of the efficiency.
const SampledValue& aimedValue(const DesignReport& report, const DesignAim& aim, std::size_t design);

/// Returns the value of an objective for a design as text, with its error if it has one, such as "0.712 +-
/// 0.001".
std::string aimedWithError(const DesignReport& report, const DesignAim& aim, std::size_t design,
                           const ReadingStyle& style = plainStyle());

/// Returns a statistic of an objective in words. Example: if `sense` is largest (the objective is maximised),
/// the 5 % quantile is "reached in 95 % of cases".
Message statisticMessage(const Statistic& statistic, Sense sense);

/// Returns the name of an objective for tables, such as "thrust q95".
std::string aimedName(const DesignAim& aim);

/// Returns the name of a design: the values of its design variables, such as "240 us" or "half_sine, 3.05 m".
/// Without design variables, the only design is that of the scenario file, and the name is "FILE".
std::string designName(const DesignStudy& study, std::uint64_t design,
                       const ReadingStyle& style = plainStyle());

/// Returns the value of an output with its unit, as text for people.
std::string outputText(const DesignStudy& study, const Output& output, double value,
                       const ReadingStyle& style = plainStyle(), int digits = 5);

/// Returns one line per limit of a design study: the most favourable value among all designs (the smallest
/// one for an upper limit), and its design. Used if no design satisfies all limits.
std::vector<Message> nearestToLimits(const DesignStudy& study, const DesignFindings& findings,
                                     const ReadingStyle& style = plainStyle());

}  // namespace drillwave
