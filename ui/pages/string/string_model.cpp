// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/string/string_model.h"

#include <QGuiApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "core/model/section_parameter.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"

namespace drillwave {
namespace {

/// The number of a section that each column shows; empty for other columns.
const std::vector<std::string_view>& fieldKeys() {
    static const std::vector<std::string_view> keys = [] {
        std::vector<std::string_view> all(StringModel::occasional);
        all[StringModel::length] = "length";
        all[StringModel::diameter] = "diameter";
        all[StringModel::bore] = "bore";
        all[StringModel::loss] = "loss";
        all[StringModel::massAfter] = "mass_after";
        all[StringModel::attenuation] = "attenuation";
        for (const SectionField& field : sectionFields())
            if (std::ranges::find(all, field.key) == all.end()) all.push_back(field.key);
        return all;
    }();
    return keys;
}

int columns() {
    return static_cast<int>(fieldKeys().size());
}

std::string_view fieldKey(int column) {
    return column >= 0 && column < columns() ? fieldKeys()[static_cast<std::size_t>(column)]
                                             : std::string_view();
}

bool isResult(int column) {
    return column >= StringModel::compression && column <= StringModel::strengthShare;
}

/// The solver takes no losses inside the hammer.
bool isLossOnTheWay(int column) {
    return column == StringModel::loss || column == StringModel::attenuation;
}

// The label of the parameter, in two lines where it is long.
QString columnTitle(int column) {
    if (column == StringModel::diameter) return StringModel::tr("diam-\neter");
    if (column == StringModel::loss) return StringModel::tr("joint\nloss");
    if (column == StringModel::massAfter) return StringModel::tr("mass at\nend");
    if (column == StringModel::attenuation) return StringModel::tr("attenu-\nation");
    QString title = coreText(findSectionField(fieldKey(column))->label);
    return title.replace(QLatin1Char(' '), QLatin1Char('\n'));
}

QString withUnit(const QString& words, const QString& unit) {
    return unit.isEmpty() ? words : QStringLiteral("%1\n[%2]").arg(words, unit);
}

}  // namespace

int StringModel::columnOf(std::string_view field) {
    return static_cast<int>(std::ranges::find(fieldKeys(), field) - fieldKeys().begin());
}

KeptParameter StringModel::ofColumn(std::string_view field) {
    return findParameter(sectionKey(SectionAddress::Chain::string, 1, field));
}

StringModel::StringModel(Document& document, QObject* parent)
    : QAbstractTableModel(parent), m_document(document) {
    connect(&document, &Document::scenarioChanged, this, &StringModel::follow);
    connect(&document.units(), &UnitChoice::changed, this, [this] {
        emit headerDataChanged(Qt::Horizontal, 0, columns() - 1);
        if (!m_rows.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, columns() - 1));
    });
    follow();
}

void StringModel::follow() {
    const Scenario& scenario = m_document.scenario();
    std::vector<StringRow> rows = stringRows(scenario.drillString);
    const bool same = std::ranges::equal(rows, m_rows, {}, &StringRow::spot, &StringRow::spot);
    if (!same) beginResetModel();
    m_rows = std::move(rows);
    m_shown = scenario.drillString;
    m_chain = chainSections(scenario.drillString, m_rows);
    m_results.reset();
    if (m_blow) m_results = stringResults(*m_blow, m_rows, m_chain);
    if (!same)
        endResetModel();
    else if (!m_rows.empty())
        emit dataChanged(index(0, 0), index(rowCount() - 1, columns() - 1));
}

void StringModel::present(const SolvedBlowPtr& blow) {
    m_blow = blow;
    m_results = stringResults(*blow, m_rows, m_chain);
    emit headerDataChanged(Qt::Horizontal, compression, strengthShare);
    if (!m_rows.empty()) emit dataChanged(index(0, compression), index(rowCount() - 1, strengthShare));
}

bool StringModel::isUsed(int column) const {
    if (column == presetName)
        return std::ranges::any_of(m_rows, [](const StringRow& row) { return !row.section.preset.empty(); });
    const std::string_view key = fieldKey(column);
    if (key.ends_with("_strength")) return false;  // the stress has a column as a share of it
    const SectionField* field = findSectionField(key);
    return field && std::ranges::any_of(m_rows, [field](const StringRow& row) {
               return field->value(row.section).value_or(0) != 0;
           });
}

KeptParameter StringModel::parameterAt(const QModelIndex& index) const {
    const std::string_view field = fieldKey(index.column());
    if (field.empty() || !index.isValid()) return nullptr;
    const StringRow& row = m_rows[static_cast<std::size_t>(index.row())];
    if (row.spot.inHammer && isLossOnTheWay(index.column())) return nullptr;
    const auto chain = row.spot.inHammer ? SectionAddress::Chain::hammer : SectionAddress::Chain::string;
    KeptParameter parameter = findParameter(sectionKey(chain, row.place, field));
    return parameter && parameter->applies(m_document.scenario()) ? parameter : nullptr;
}

int StringModel::rowOf(const SectionSpot& spot) const {
    const auto found = std::ranges::find(m_rows, spot, &StringRow::spot);
    return found == m_rows.end() ? -1 : static_cast<int>(found - m_rows.begin());
}

int StringModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int StringModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : columns();
}

Qt::ItemFlags StringModel::flags(const QModelIndex& index) const {
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (!index.isValid()) return flags;
    const StringRow& row = m_rows[static_cast<std::size_t>(index.row())];
    const bool editable = index.column() == repeat
                              ? row.repeat.has_value()
                              : index.column() == sectionName || bool(parameterAt(index));
    return editable ? flags | Qt::ItemIsEditable : flags;
}

QVariant StringModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const StringRow& row = m_rows[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
            return shown(index);
        case Qt::EditRole:
            if (index.column() == sectionName) return QString::fromStdString(row.section.name);
            if (index.column() == repeat) return row.repeat ? row.repeat->times : 1;
            return shown(index);
        case Qt::ToolTipRole:
            return toolTip(index);
        case Qt::ForegroundRole:
            // A name that is none of its own.
            if (index.column() == sectionName && row.section.name.empty())
                return QGuiApplication::palette().brush(QPalette::PlaceholderText);
            return {};
        case Qt::TextAlignmentRole:
            return int((index.column() == sectionName || index.column() == presetName ? Qt::AlignLeft
                                                                                      : Qt::AlignRight) |
                       Qt::AlignVCenter);
        default:
            return {};
    }
}

QVariant StringModel::shown(const QModelIndex& index) const {
    const StringRow& row = m_rows[static_cast<std::size_t>(index.row())];
    if (index.column() == repeat) return repeatCell(row);
    if (index.column() == sectionName) return row.words;
    if (index.column() == presetName) return coreText(row.section.preset);
    if (isResult(index.column())) return resultCell(index.row(), index.column());
    const KeptParameter parameter = parameterAt(index);
    return parameter ? numberCell(row, *parameter) : noNumber;
}

QString StringModel::numberCell(const StringRow& /*row*/, const Parameter& parameter) const {
    const std::optional<double> si = parameter.value(m_document.scenario());
    const std::string_view field = parameter.address->field->key;
    if (!si) return noNumber;
    // Most sections have none of these.
    const bool isUsual = *si == 0 && (field == "loss" || field == "mass_after" || field == "attenuation");
    if (isUsual) return noNumber;
    return fieldText(*si, parameter.quantity, m_document.units().fieldUnit(*ofColumn(field)), QLocale());
}

// A bracket over the rows of the repeat, with its number at the first.
QString StringModel::repeatCell(const StringRow& row) const {
    if (!row.repeat) return {};
    const auto [times, index, size] = *row.repeat;
    const QString number = QStringLiteral("%1 × ").arg(QLocale().toString(times));
    if (size == 1) return number + QStringLiteral("[");
    if (index == 0) return number + QStringLiteral("⎡");
    return index + 1 == size ? QStringLiteral("⎣") : QStringLiteral("⎢");
}

QString StringModel::resultCell(int row, int column) const {
    if (!m_results) return noNumber;
    const RowResult& result = m_results->rows[static_cast<std::size_t>(row)];
    if (column == strengthShare)
        return result.use ? numberText(100 * result.use->share(), 3, QLocale()) : noNumber;
    if (column == reflected)
        return result.reflected ? numberText(100 * result.reflected->size, 3, QLocale()) : noNumber;
    const RowPeak& peak = column == compression ? result.compression : result.tension;
    return numberText(peak.size / m_blow->scales.stress * m_blow->units.stress.factor, 4, QLocale());
}

QString StringModel::peakText(const RowPeak& peak) const {
    const Scales& scales = m_blow->scales;
    const ShownUnits& units = m_blow->units;
    const QLocale locale;
    const QString stress = quantityText(peak.size / scales.stress, units.stress, locale);
    if (!(peak.size > 0)) return stress;
    // Places closer to an end than this are at the end.
    constexpr double rounding = 1e-9;
    const double place = peak.place / scales.length < rounding ? 0 : peak.place / scales.length;
    return tr("%1 at %2 from its rear end, %3")
        .arg(stress, quantityText(place, units.length, locale),
             quantityText(peak.time / scales.time, units.time, locale));
}

QString StringModel::useText(const StringRow& row, const RowResult& result) const {
    const StrengthUse& use = *result.use;
    const bool isFatigue = use.of == StrengthUse::Strength::fatigue;
    const RowPeak peak{use.peak.stress, use.peak.place, use.peak.time, result.useSection};
    return (isFatigue ? tr("%1: %2, of the fatigue strength of %3")
                      : tr("%1: %2, of the yield strength of %3"))
        .arg(row.nameAt(result.useSection), peakText(peak),
             quantityText(use.strength / m_blow->scales.stress, m_blow->units.stress, QLocale()));
}

QString StringModel::placeText(int row) const {
    const StringRow& at = m_rows[static_cast<std::size_t>(row)];
    return at.spot.inHammer ? tr("H%1").arg(at.place) : QString::number(at.place);
}

QString StringModel::toolTip(const QModelIndex& index) const {
    const StringRow& row = m_rows[static_cast<std::size_t>(index.row())];
    const int column = index.column();
    if (column == repeat)
        return row.repeat
                   ? tr("These sections are repeated %1 times. Type another number; 1 removes the repeat.")
                         .arg(row.repeat->times)
                   : QString();
    if (column == sectionName) return tr("Name of the section, also used in keys of parameters");
    if (column == presetName) return tr("Preset of the section; the name is removed when a number changes");
    if (isResult(column)) {
        if (!m_results) return {};
        const RowResult& result = m_results->rows[static_cast<std::size_t>(index.row())];
        if (column == strengthShare) return result.use ? useText(row, result) : tr("No strength is given");
        if (column == reflected)
            return result.reflected ? tr("Share of the hammer energy reflected by the joint after %1")
                                          .arg(row.nameAt(result.reflected->section))
                                    : QString();
        const bool isTension = column == tension;
        const auto text = [&](const RowPeak& peak) {
            return row.nameAt(peak.section) + QStringLiteral(": ") + peakText(peak);
        };
        const RowPeak& after = isTension ? result.tensionAfter : result.compressionAfter;
        const QString during = text(isTension ? result.tension : result.compression);
        return after.size > 0 ? during + tr("\nin the residual waves: %1").arg(text(after)) : during;
    }
    if (const KeptParameter parameter = parameterAt(index)) return coreText(parameter->meaning);
    if (isLossOnTheWay(column)) return tr("The hammer has no internal losses");
    return tr("The section has a cross-section instead of diameters");
}

QVariant StringModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical) {
        if (section >= rowCount()) return {};
        if (role == Qt::ToolTipRole) return tr("Place in keys: %1").arg(placeText(section));
        if (role != Qt::DisplayRole) return {};
        return placeText(section);
    }
    if (role == Qt::ToolTipRole) {
        if (section == compression) return tr("Largest compression of the section during the blow");
        if (section == tension) return tr("Largest tension of the section during the blow");
        if (section == reflected)
            return tr(
                "Share of the hammer energy reflected by the joint after the section; of a repeat, by the "
                "joint that reflects most");
        if (section == strengthShare)
            return tr(
                "Largest stress during the blow as a share of the strength: tension over fatigue strength, "
                "or any stress over yield strength, whichever is larger");
        if (section == presetName) return tr("Preset of the section");
        if (const std::string_view field = fieldKey(section); !field.empty())
            return coreText(findSectionField(field)->meaning);
        return {};
    }
    if (role != Qt::DisplayRole) return {};
    const QString stressUnit = m_blow ? m_blow->units.stress.unit : QString();
    switch (section) {
        case repeat:
            return tr("repeat");
        case sectionName:
            return tr("name");
        case compression:
            return withUnit(tr("compres-\nsion"), stressUnit);
        case tension:
            return withUnit(tr("tension"), stressUnit);
        case reflected:
            return withUnit(tr("joint\nreflects"), QStringLiteral("%"));
        case strengthShare:
            return withUnit(tr("strength\nused"), QStringLiteral("%"));
        case presetName:
            return tr("preset");
        default:
            break;
    }
    return withUnit(columnTitle(section),
                    shownUnitName(m_document.units().fieldUnit(*ofColumn(fieldKey(section))).name));
}

bool StringModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    // A cell that is still open when another file is opened hands over its text as its page hides.
    const Scenario& scenario = m_document.scenario();
    if (m_rows.empty() || scenario.drillString != m_shown) return false;
    if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable)) return false;
    const StringRow row = m_rows[static_cast<std::size_t>(index.row())];
    if (index.column() == sectionName) return rename(row, value.toString().trimmed());
    const KeptParameter parameter = parameterAt(index);
    if (!value.isValid() && parameter && parameter->address->field->clear) {
        m_document.clear(*parameter, m_document.newGesture());
        return report({});
    }
    bool isNumber = false;
    const double number = value.toDouble(&isNumber);
    if (!isNumber) return false;
    if (index.column() == repeat) return setTimes(row, number);
    return report(m_document.assign(*parameter, number, m_document.newGesture()));
}

bool StringModel::rename(const StringRow& row, const QString& name) {
    if (const Message problem = sectionNameProblem(name.toStdString()); !problem.isEmpty())
        return report(tr("The name %1").arg(translated(problem)));
    Scenario changed = m_document.scenario();
    sectionAt(changed.drillString, row.spot).name = name.toStdString();
    return report(m_document.useScenario(changed, tr("call %1 “%2”").arg(row.name(), name)));
}

bool StringModel::setTimes(const StringRow& row, double times) {
    const bool isWhole = times == std::floor(times) && times >= 1 && times <= double(maximumSections);
    if (!isWhole) return report(tr("A repeat is a whole number from 1 to %1").arg(maximumSections));
    if (!row.repeat || times == row.repeat->times) return false;
    Scenario changed = m_document.scenario();
    setRepeat(changed.drillString, row.spot.part, static_cast<int>(times));
    return report(m_document.useScenario(changed, times == 1
                                                      ? tr("remove the repeat of %1").arg(row.name())
                                                      : tr("repeat %1 %2 times").arg(row.name()).arg(times)));
}

bool StringModel::report(const QString& problem) {
    emit refused(problem);
    return problem.isEmpty();
}

}  // namespace drillwave
