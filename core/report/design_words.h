// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences about a study of designs.
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

/// How the sentences of a study name designs, aims and numbers: here by the keys that commands read, with
/// numbers and units of a style. A window names all of them as its rows and axes do.
class DesignNames {
  public:
    /// Both must outlive the names.
    explicit DesignNames(const DesignStudy& study, const ReadingStyle& style = plainStyle())
        : m_study(study), m_style(style) {}
    DesignNames(const DesignNames&) = delete;
    DesignNames& operator=(const DesignNames&) = delete;
    virtual ~DesignNames() = default;

    const ReadingStyle& style() const { return m_style; }
    /// "240 us, 3.05 m"
    virtual std::string design(std::uint64_t design) const;
    /// "efficiency q05"
    virtual Message aim(const DesignAim& aim) const;
    /// A choice within a sentence: its key for commands, "duration" in print.
    virtual Message choice(const SweepAxis& choice) const;
    /// A number of an output with its unit.
    virtual std::string value(const Output& output, double value, int digits) const;
    /// "0.712 +- 0.001": what an aim is about, of a design, with its error where it has one.
    virtual std::string aimed(const DesignReport& report, const DesignAim& aim, std::size_t design) const;

  private:
    const DesignStudy& m_study;
    const ReadingStyle& m_style;
};

/// Remarks on the answer.
struct DesignRemark {
    bool isWarning = false;
    std::string code;  ///< "flat_optimum", …
    Message text;
};
std::vector<DesignRemark> remarksOn(const DesignReport& report, const DesignNames& names);
std::vector<DesignRemark> remarksOn(const DesignReport& report, const ReadingStyle& style = plainStyle());

/// The answer of a study, as the aims decide in their order.
enum class DesignHeadline {
    keep,          ///< no design is better than the present one
    change,        ///< one is, or none of them is the present one
    noDifference,  ///< all are feasible and equal, but for errors
    noneFeasible,  ///< none meets the limits
};
/// "keep", "change", "no_difference", "none_feasible".
std::string_view name(DesignHeadline headline);
/// Nothing of a study without choices.
std::optional<DesignHeadline> headlineOf(const DesignReport& report);
/// The headline as a sentence; empty where there is none.
Message designAnswerMessage(const DesignReport& report, const DesignNames& names);
/// The first warning about the design to take, and the number of further ones; empty without any.
Message designWarning(const DesignReport& report, const DesignNames& names);
/// The headline as a sentence, with the warnings about the design to take; empty where there is none.
Message headlineMessage(const DesignReport& report, const DesignNames& names);
Message headlineMessage(const DesignReport& report, const ReadingStyle& style = plainStyle());

/// The marks of a design: "best_uncertain", "best_nominal", "equal" to the design to take, "present".
/// `present` is presentDesign().
std::vector<std::string_view> marksOf(const DesignReport& report, std::size_t design,
                                      std::optional<std::size_t> present);

/// Whether a study has samples enough to say which share of a scatter a number has at all.
bool carriesShares(const DesignStudy& study);

/// Which uncertain number (as in OutputSensitivity) is worth measuring first for an output that is aimed at,
/// by its number there: that of the largest share, once the samples carry it.
std::optional<std::size_t> firstToMeasure(const DesignReport& report, std::size_t aimed);

/// Returns the statistic of an aim for a design (from 0).
const SampledValue& aimedValue(const DesignReport& report, const DesignAim& aim, std::size_t design);

/// "0.712 +- 0.001": the same as people read it, with its error where it has one.
std::string aimedWithError(const DesignReport& report, const DesignAim& aim, std::size_t design,
                           const ReadingStyle& style = plainStyle());

/// "thrust q95"
std::string aimedName(const DesignAim& aim);

/// "240 us", "half_sine, 3.05 m": a design by its choices; "FILE" without any.
std::string designName(const DesignStudy& study, std::uint64_t design,
                       const ReadingStyle& style = plainStyle());

/// A number of an output with its unit, as people read it.
std::string outputText(const DesignStudy& study, const Output& output, double value,
                       const ReadingStyle& style = plainStyle(), int digits = 5);

/// Returns one line per limit with the nearest value of all designs, if no design meets all limits.
std::vector<Message> nearestToLimits(const DesignStudy& study, const DesignFindings& findings,
                                     const ReadingStyle& style = plainStyle());

}  // namespace drillwave
