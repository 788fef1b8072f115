// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of hammer and string in the order of the file, with the results of the blow for each.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "core/blow/string_blow.h"
#include "core/model/string_edit.h"
#include "ui/job/solved_blow.h"

namespace drillwave {

/// Row of the table of sections: one section of hammer or drill string as in the scenario file. A section in
/// a repeat has one row for all its copies.
struct StringRow {
    SectionSpot spot;
    Section section;
    std::uint64_t place = 1;  ///< number of the section in its hammer or string (from 1), for its first copy
    /// Repeat (group of sections that occurs several times) that contains the section.
    struct Repeat {
        int times = 1;
        /// Index of the section in the repeat (from 0), and number of sections in the repeat.
        std::size_t index = 0, size = 1;
        bool operator==(const Repeat&) const = default;
    };
    std::optional<Repeat> repeat = {};
    QString words = {};                    ///< name of the row for sentences, such as "2nd to 4th rod"
    std::vector<QString> placeWords = {};  ///< name of each copy of the section, such as "2nd rod"

    /// Returns the name of the section, such as "adapter"; without a name, "section 3" or "hammer 1".
    QString name() const;
    /// Returns the name for sentences of one copy of the section, such as "3rd rod". `itsPlace` is its number
    /// in hammer or string (from 1).
    const QString& nameAt(std::uint64_t itsPlace) const;
};
/// Returns the rows of the table of sections: hammer and string in the order of the scenario file.
std::vector<StringRow> stringRows(const DrillString& drillString);

/// One of all sections from hammer to bit, in which each copy of a repeated section is listed separately.
struct ChainSection {
    std::size_t row = 0;      ///< index in stringRows()
    std::uint64_t place = 1;  ///< number of the section in its hammer or string (from 1)
    double start = 0;         ///< distance of its rear end from the rear of the hammer [m]
};
/// Returns all sections from the rear of the hammer to the bit, in the order of sectionStresses(). `rows` is
/// the result of stringRows().
std::vector<ChainSection> chainSections(const DrillString& drillString, const std::vector<StringRow>& rows);

/// Largest stress (or reflected energy) of one kind, over all copies of a repeated section.
struct RowPeak {
    double size = 0;            ///< stress [Pa], or share of the hammer energy (0 … 1)
    double place = 0;           ///< distance from the rear end of the section [m]
    double time = 0;            ///< time of the peak [s]
    std::uint64_t section = 1;  ///< number of the copy with the peak, in its hammer or string
};
/// Results of a blow for one row of the table of sections.
struct RowResult {
    RowPeak compression, tension, compressionAfter, tensionAfter;
    std::optional<RowPeak> reflected;  ///< energy reflected at the section's front joint; empty in the hammer
    std::optional<StrengthUse> use;    ///< largest stress as a share of the strength
    std::uint64_t useSection = 1;      ///< number of the copy that `use` belongs to
};

/// Results of a solved blow for the table of sections: one entry for each row. Also the stresses of every
/// section from hammer to bit.
struct StringResults {
    std::vector<RowResult> rows;
    std::vector<SectionStress> sections;
    double largest = 0;  ///< largest stress of all sections [Pa]
};
/// Returns the results of a blow for these rows. Empty if the blow is not solved, or if its string has other
/// sections than `rows`.
std::optional<StringResults> stringResults(const SolvedBlow& blow, const std::vector<StringRow>& rows,
                                           const std::vector<ChainSection>& chain);

}  // namespace drillwave
