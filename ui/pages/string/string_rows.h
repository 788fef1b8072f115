// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of a hammer and a string in the order of a file, with what the blow does to each.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "core/blow/string_blow.h"
#include "core/model/string_edit.h"
#include "ui/job/solved_blow.h"

namespace drillwave {

/// A section as in a file. A section in a repeat is listed once for all its places.
struct StringRow {
    SectionSpot spot;
    Section section;
    std::uint64_t place = 1;  ///< the first one in its hammer or string
    /// The repeat that contains the section.
    struct Repeat {
        int times = 1;
        std::size_t index = 0, size = 1;  ///< which of the sections of the repeat
        bool operator==(const Repeat&) const = default;
    };
    std::optional<Repeat> repeat = {};
    QString words = {};                    ///< of the row: "2nd to 4th rod"
    std::vector<QString> placeWords = {};  ///< of each of its places: "2nd rod"

    /// "adapter", else "section 3", "hammer 1".
    QString name() const;
    /// Returns how sentences call the section at one of its places: "hammer 1", "3rd rod".
    const QString& nameAt(std::uint64_t itsPlace) const;
};
std::vector<StringRow> stringRows(const DrillString& drillString);

/// A section where it is in the chain of hammer and string, repeats written out.
struct ChainSection {
    std::size_t row = 0;      ///< of stringRows()
    std::uint64_t place = 1;  ///< in its hammer or string
    double start = 0;         ///< of its rear end from that of the hammer [m]
};
/// Returns all sections from the rear of the hammer to the bit: those of sectionStresses().
std::vector<ChainSection> chainSections(const DrillString& drillString, const std::vector<StringRow>& rows);

/// The largest of one kind over all the places of a row.
struct RowPeak {
    double size = 0;            ///< stress [Pa], or share of the energy of the hammer
    double place = 0;           ///< from its rear end [m]
    double time = 0;            ///< [s]
    std::uint64_t section = 1;  ///< the place in its hammer or string where it is that large
};
struct RowResult {
    RowPeak compression, tension, compressionAfter, tensionAfter;
    std::optional<RowPeak> reflected;  ///< by its far joint, in the string
    std::optional<StrengthUse> use;    ///< the largest over all places
    std::uint64_t useSection = 1;      ///< the place of that
};

/// Results of a solved blow on that string: by row, and by section of the chain.
struct StringResults {
    std::vector<RowResult> rows;
    std::vector<SectionStress> sections;
    double largest = 0;  ///< stress of all of them [Pa]
};
/// Returns nothing if the blow is unsolved, or of a string with other sections.
std::optional<StringResults> stringResults(const SolvedBlow& blow, const std::vector<StringRow>& rows,
                                           const std::vector<ChainSection>& chain);

}  // namespace drillwave
