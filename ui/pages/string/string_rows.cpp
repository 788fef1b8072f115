// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/string/string_rows.h"

#include <algorithm>

#include "core/model/section_words.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

void take(RowPeak& peak, const RowPeak& other) {
    if (other.size > peak.size) peak = other;
}

}  // namespace

QString StringRow::name() const {
    if (!section.name.empty()) return QString::fromStdString(section.name);
    return (spot.inHammer ? drillwave::tr("hammer %1") : drillwave::tr("section %1")).arg(place);
}

const QString& StringRow::nameAt(std::uint64_t itsPlace) const {
    const std::uint64_t size = repeat ? repeat->size : 1;
    return placeWords[static_cast<std::size_t>((itsPlace - place) / size)];
}

std::vector<StringRow> stringRows(const DrillString& drillString) {
    std::vector<StringRow> rows;
    const std::vector<Message> words = rowWords(drillString), ofPlaces = stringSectionWords(drillString);
    for (const SectionSpot& spot : sectionSpots(drillString)) {
        StringRow row{spot, sectionAt(drillString, spot), placeOf(drillString, spot)};
        if (!spot.inHammer)
            if (const StringPart& part = drillString.parts[spot.part]; part.group)
                row.repeat = StringRow::Repeat{part.repeat, spot.index, part.sections.size()};
        row.words = translated(words[rows.size()]);
        const int times = row.repeat ? row.repeat->times : 1;
        const std::size_t size = row.repeat ? row.repeat->size : 1;
        for (std::size_t n = 0; n < static_cast<std::size_t>(std::max(times, 0)); ++n)
            row.placeWords.push_back(
                spot.inHammer ? row.words
                              : translated(ofPlaces[static_cast<std::size_t>(row.place) - 1 + n * size]));
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<ChainSection> chainSections(const DrillString& drillString, const std::vector<StringRow>& rows) {
    std::vector<ChainSection> chain;
    double start = 0;
    std::uint64_t place = 0;
    const auto add = [&](std::size_t row) {
        chain.push_back({row, ++place, start});
        start += rows[row].section.length;
    };
    std::size_t row = 0;
    while (row < rows.size() && rows[row].spot.inHammer) add(row++);
    place = 0;
    for (const StringPart& part : drillString.parts) {
        for (int n = 0; n < part.repeat; ++n)
            for (std::size_t i = 0; i < part.sections.size(); ++i) add(row + i);
        row += part.sections.size();
    }
    return chain;
}

std::optional<StringResults> stringResults(const SolvedBlow& blow, const std::vector<StringRow>& rows,
                                           const std::vector<ChainSection>& chain) {
    if (!blow.fault.isEmpty()) return std::nullopt;
    const DrillString& solved = blow.scenario.drillString;
    const auto spot = [](const StringRow& row) { return row.spot; };
    StringResults results;
    results.sections = sectionStresses(blow.scenario, blow.impact);
    if (results.sections.empty() || results.sections.size() != chain.size()) return std::nullopt;
    if (!std::ranges::equal(sectionSpots(solved), rows, {}, {}, spot)) return std::nullopt;
    results.rows.resize(rows.size());
    const std::vector<std::optional<StrengthUse>> uses = strengthUses(blow.scenario, results.sections);
    const std::vector<double>& reflected = blow.impact.jointReflection;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const SectionStress& stress = results.sections[i];
        RowResult& row = results.rows[chain[i].row];
        const std::uint64_t place = chain[i].place;
        const auto peakOf = [place](const StressPeak& peak) {
            return RowPeak{peak.stress, peak.place, peak.time, place};
        };
        take(row.compression, peakOf(stress.compression));
        take(row.tension, peakOf(stress.tension));
        take(row.compressionAfter, peakOf(stress.compressionAfter));
        take(row.tensionAfter, peakOf(stress.tensionAfter));
        if (uses[i] && (!row.use || uses[i]->share() > row.use->share())) {
            row.use = uses[i];
            row.useSection = place;
        }
        results.largest = std::max({results.largest, stress.compression.stress, stress.tension.stress});
        if (rows[chain[i].row].spot.inHammer || place > reflected.size()) continue;
        if (!row.reflected) row.reflected.emplace();
        take(*row.reflected, {reflected[place - 1], 0, 0, place});
    }
    return results;
}

}  // namespace drillwave
