// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/string_validation.h"

#include <algorithm>
#include <cmath>

#include "core/model/parameter.h"
#include "core/model/scales.h"
#include "core/model/section_address.h"
#include "core/model/section_pieces.h"

namespace drillwave {
namespace {

using Chain = SectionAddress::Chain;

/// Enough to see what is the matter with a thousand sections.
constexpr std::size_t enoughProblems = 100;

class SectionCheck {
  public:
    explicit SectionCheck(const DrillString& drillString) : m_string(drillString) {}

    std::vector<InputProblem> problems() {
        checkHammer();
        checkParts();
        each([this](const std::string& key, const Section& section) { checkSection(key, section); });
        if (m_problems.empty()) checkHammerLosses();
        if (m_problems.empty()) checkFace();
        if (m_problems.empty())
            each([this](const std::string& key, const Section& section) { checkDerived(key, section); });
        return std::move(m_problems);
    }

  private:
    void report(const std::string& key, const std::string& value, const Message& reason) {
        m_problems.push_back(valueProblem(key, value, reason));
    }

    template <class Check>
    void each(const Check& check) {
        for (std::size_t i = 0; i < m_string.hammer.sections.size() && goesOn(); ++i)
            check(sectionKey(Chain::hammer, i + 1), m_string.hammer.sections[i]);
        for (const PlacedSection& placed : placedSections(m_string))
            if (goesOn()) check(sectionKey(Chain::string, placed.place), *placed.section);
    }
    bool goesOn() const { return m_problems.size() < enoughProblems; }

    void checkHammer() {
        const std::size_t count = m_string.hammer.sections.size();
        if (count > maximumSections) report("hammer.sections", "", tooManySections(count));
    }

    void checkParts() {
        if (m_string.parts.empty()) report("string", "", translatable("must have at least one section"));
        for (const StringPart& part : m_string.parts) {
            if (part.sections.empty() || (!part.group && part.sections.size() != 1))
                report("string", "",
                       translatable("each part must be one section, or a repeat of at least one"));
            const Message reason =
                rangeProblem(*findParameter("string.repeat"), static_cast<double>(part.repeat));
            if (!reason.isEmpty()) report("string.repeat", std::to_string(part.repeat), reason);
            if (!part.group && part.repeat > 1)
                report("string.repeat", std::to_string(part.repeat), translatable("only a repeat has it"));
        }
        if (const std::uint64_t count = sectionCount(m_string); count > maximumSections)
            report("string", "", tooManySections(count));
    }

    void checkSection(const std::string& key, const Section& section) {
        const auto text = [](const SectionField& field, double value) {
            return formatQuantity(value, field.quantity, field.displayUnit());
        };
        for (const SectionField& field : sectionFields()) {
            const std::optional<double> value = field.value(section);
            const Message reason = value ? rangeProblem(field, *value) : Message();
            if (!reason.isEmpty()) report(key + "." + std::string(field.key), text(field, *value), reason);
        }
        for (const ShapeProblem& problem : shapeProblems(section)) {
            const SectionField& field = *findSectionField(problem.field);
            report(key + "." + std::string(field.key), text(field, *field.value(section)), problem.reason);
        }
        const Message reason = sectionNameProblem(section.name);
        if (!reason.isEmpty()) report(key + ".name", section.name, reason);
    }

    /// A hammer that flies loses nothing: waves that decay while it does would slow it down.
    void checkHammerLosses() {
        const std::vector<Section>& sections = m_string.hammer.sections;
        const auto refuse = [this](std::size_t i, const char* field, double value) {
            const SectionField& losing = *findSectionField(field);
            report(
                sectionKey(Chain::hammer, i + 1) + "." + field,
                formatQuantity(value, losing.quantity, losing.displayUnit()),
                translatable("losses inside the hammer are not part of the model: give them to sections of "
                             "the string"));
        };
        for (std::size_t i = 0; i < sections.size() && goesOn(); ++i) {
            if (sections[i].attenuation > 0) refuse(i, "attenuation", sections[i].attenuation);
            // behind the last section there is no joint
            if (sections[i].loss > 0 && i + 1 < sections.size()) refuse(i, "loss", sections[i].loss);
        }
    }

    /// A cone of a hammer may end in a face that fits into the bore of what it strikes.
    void checkFace() {
        if (m_string.hammer.sections.empty()) return;
        const Section& last = m_string.hammer.sections.back();
        const Section& struck = *expandedSections(m_string).front();
        const double hole = struck.area ? 0 : struck.bore;
        if (isUniform(last) || outerDiameterAt(last, 1) > hole) return;
        const SectionField& end = *findSectionField(endKey(last));
        const SectionField& bore = *findSectionField("bore");
        report(sectionKey(Chain::hammer, m_string.hammer.sections.size()) + "." + std::string(end.key),
               formatQuantity(*end.value(last), end.quantity, end.displayUnit()),
               {translatable("is so narrow that the face meets no more than the bore of %1 of the section it "
                             "strikes"),
                {formatQuantity(hole, bore.quantity, bore.displayUnit())}});
    }

    void checkDerived(const std::string& key, const Section& section) {
        const RodProperties properties = propertiesOf(section, m_string.material);
        for (const double value :
             {properties.area, properties.impedance, properties.transitTime, properties.mass})
            if (!std::isfinite(value) || value <= 0)
                return report(
                    key, "",
                    translatable("the values are so large or small that its impedance, transit time "
                                 "or mass overflows"));
    }

    const DrillString& m_string;
    std::vector<InputProblem> m_problems;
};

}  // namespace

std::vector<InputProblem> sectionProblems(const DrillString& drillString) {
    return SectionCheck(drillString).problems();
}

Message tooManySections(std::uint64_t count) {
    return {translatable("has %1 sections, its repeats written out; at most %2 are followed"),
            {std::to_string(count), std::to_string(maximumSections)}};
}

}  // namespace drillwave
