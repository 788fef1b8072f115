// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/signal_fields.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <cmath>

#include "core/blow/blow_waves.h"
#include "core/model/chain_words.h"
#include "core/model/scales.h"
#include "ui/import/import_rows.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {
namespace {

/// Maximum number of points of a blow in the text of a scenario file.
constexpr int mostBlowPoints = 10'000;
constexpr int mostCurvePoints = 100'000;
constexpr int usualPoints = 1000;

/// Share of a record, from its beginning, that is probably quiet.
constexpr double restShare = 0.03;

constexpr int noUnit = -1;  // is chosen

enum Sense { tension, compression };

// To one digit, for a proposal.
double oneDigit(double value) {
    if (!(value > 0)) return value;
    const double decade = std::pow(10, std::floor(std::log10(value)));
    return std::max(1.0, std::round(value / decade)) * decade;
}

int value(auto choice) {
    return static_cast<int>(choice);
}

}  // namespace

SignalFields::SignalFields(const UnitChoice& units, QWidget* parent)
    : QWidget(parent), m_units(units), m_form(new QFormLayout(this)) {
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setVerticalSpacing(3);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    addUnit();
    m_gauge = std::make_unique<GaugeRows>(*m_form, [this] {
        showRows();
        emit changed();
    });
    m_fields += m_gauge->fields();
    addZero();
    addTimes();
    addEnd();
    for (ChoiceBox* box : {m_unit, m_positive, m_zero, m_scaling})
        connect(box, &QComboBox::currentIndexChanged, this, [this, box] {
            m_touched.insert(box);
            showRows();
            emit changed();
        });
    connect(m_kind, &QComboBox::currentIndexChanged, this, [this] {
        fillUnits({});
        showRows();
        emit changed();
    });
    fillUnits({});
    showRows();
}

QuantityField* SignalFields::quantity(const char* name, const QString& label, const QString& toolTip,
                                      Quantity kind, const char* unit, FieldRange range,
                                      std::optional<double> si) {
    const auto touch = [this, index = m_fields.size()] {
        m_touched.insert(m_fields[index]);
        emit changed();
    };
    QuantityField* field = addQuantity(*m_form, {name, label, toolTip}, kind, unit, range, si, touch);
    m_fields.append(field);
    return field;
}

SignalFields::~SignalFields() = default;

void SignalFields::addUnit() {
    m_place = quantity("place", tr("place x"),
                       tr("Distance of the gauge from the struck end; negative in the hammer"),
                       Quantity::length, "m", FieldRange::any, {});
    m_place->setOptional(tr("not given"));
    m_kind = addChoice(*m_form, {"kind", tr("signal is"), tr("Quantity that was recorded")},
                       {{tr("force"), value(SignalKind::force)},
                        {tr("strain"), value(SignalKind::strain)},
                        {tr("output of a bridge"), value(SignalKind::bridge)},
                        {tr("voltage"), value(SignalKind::voltage)},
                        {tr("stress"), value(SignalKind::stress)},
                        {tr("particle velocity"), value(SignalKind::velocity)}});
    m_unit = addChoice(*m_form, {"valueUnit", tr("unit"), tr("Unit of the numbers")}, {});
    m_positive = addChoice(*m_form,
                           {"positive", tr("positive is"),
                            tr("Meaning of positive numbers. In this program tension is positive in rods; on "
                               "the rock and in a blow, compression is.")},
                           {{tr("tension"), tension}, {tr("compression"), compression}});
}

void SignalFields::addZero() {
    m_zero = addChoice(*m_form, {"zero", tr("zero line"), tr("Zero level, subtracted from all samples")},
                       {{tr("as recorded"), value(ZeroLine::asRecorded)},
                        {tr("mean of the first"), value(ZeroLine::ofFirstSamples)},
                        {tr("a value"), value(ZeroLine::chosen)}});
    m_zeroSpan = quantity("zeroSpan", tr("first"), tr("Time at the start of the record without a signal"),
                          Quantity::time, "us", FieldRange::notNegative, 0);
    m_zeroValue = quantity("zeroValue", tr("zero is at"), tr("In the unit of the column"), Quantity::ratio,
                           "", FieldRange::any, 0);
}

void SignalFields::addTimes() {
    m_from = quantity("from", tr("from"), tr("Samples before this time of the file are left out"),
                      Quantity::time, "us", FieldRange::any, {});
    m_to = quantity("to", tr("to"), tr("Samples after this time of the file are left out"), Quantity::time,
                    "us", FieldRange::any, {});
    m_from->setOptional(tr("beginning"));
    m_to->setOptional(tr("end"));
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](const char* name, const QString& text, const QString& toolTip, auto pressed) {
        auto* button = new QPushButton(text, row);
        button->setObjectName(QLatin1String(name));
        button->setToolTip(toolTip);
        button->setAutoDefault(false);
        button->setMinimumWidth(1);
        connect(button, &QPushButton::clicked, this, pressed);
        layout->addWidget(button);
    };
    add("aroundPeak", tr("Peak"), tr("The range around the peak in which the signal exceeds 2 % of it"),
        [this] { emit timesAroundPeakWanted(); });
    add("visible", tr("View"), tr("The range shown by the plot: zoom there first"),
        [this] { emit visibleTimesWanted(); });
    add("all", tr("All"), tr("All of the record"), [this] { setTimes({}); });
    m_form->addRow(tr("range"), row);
    m_rangeButtons = row;
}

void SignalFields::addEnd() {
    m_clip = new QCheckBox(tr("clip what is negative"), this);
    m_clip->setObjectName(QStringLiteral("clip"));
    m_clip->setToolTip(tr("Forces below zero become zero: a hammer only pushes, and noise does not"));
    m_clip->setChecked(true);
    m_form->addRow(QString(), m_clip);
    connect(m_clip, &QCheckBox::toggled, this, &SignalFields::changed);
    m_scaling = addChoice(*m_form, {"scaling", tr("scale"), tr("Scaling of all forces")},
                          {{tr("as it is"), value(Scaling::none)},
                           {tr("by a factor"), value(Scaling::byFactor)},
                           {tr("to an impulse"), value(Scaling::toImpulse)}});
    m_factor = quantity("factor", tr("factor"), tr("All forces are multiplied by it"), Quantity::ratio, "",
                        FieldRange::notZero, 1);
    m_impulse = quantity("impulse", tr("impulse"), tr("Wanted impulse of the signal"), Quantity::impulse,
                         "N s", FieldRange::positive, 51);
    m_points = addCount(*m_form,
                        {"points", tr("points at most"),
                         tr("Largest number of points to keep. By default a blow keeps as many as needed for "
                            "impulse and e to within 1e-4. The summary below gives the largest deviation.")},
                        2, mostBlowPoints, usualPoints);
    connect(m_points, &QSpinBox::valueChanged, this, [this] {
        m_touched.insert(m_points);
        emit changed();
    });
}

void SignalFields::setUse(ImportUse use) {
    m_use = use;
    const QSignalBlocker quiet(m_points);
    m_points->setMaximum(use == ImportUse::blow ? mostBlowPoints : mostCurvePoints);
    showRows();
    emit changed();
}

void SignalFields::setScenario(const Scenario& scenario) {
    if (scenario == m_scenario) return;
    m_scenario = scenario;
    m_gauge->offerScenario(hasUnits(scenario));
    showRows();
    emit changed();
}

void SignalFields::setUnit(const std::optional<NamedSignalUnit>& unit, SignalKind likely) {
    m_unitIsKnown = unit.has_value();
    choose(*m_kind, value(unit ? unit->kind : likely));
    fillUnits(unit ? std::optional(unit->unit) : std::nullopt);
    showRows();
    emit changed();
}

void SignalFields::fillUnits(std::optional<SignalUnit> wanted) {
    m_unitList = signalUnits(static_cast<SignalKind>(chosenValue(*m_kind)));
    QList<RowChoice> entries;
    for (const SignalUnit& unit : m_unitList)
        entries.append({shownUnitName(unit.name), static_cast<int>(entries.size())});
    if (!m_unitIsKnown) entries.prepend({tr("choose"), noUnit});
    setEntries(*m_unit, entries);
    for (std::size_t i = 0; wanted && i < m_unitList.size(); ++i)
        if (m_unitList[i] == *wanted) choose(*m_unit, static_cast<int>(i));
    if (!wanted) choose(*m_unit, m_unitIsKnown ? 0 : noUnit);
}

void SignalFields::proposeChoice(ChoiceBox& box, int choice) const {
    if (!m_touched.contains(&box)) choose(box, choice);
}

// A strain has a zero line to be found; a force has been given one. A choice of the user stays.
void SignalFields::proposeZero(RecordSpan record) {
    const bool isForce = chosenValue(*m_kind) == value(SignalKind::force);
    proposeChoice(*m_zero, value(isForce ? ZeroLine::asRecorded : ZeroLine::ofFirstSamples));
    if (!m_touched.contains(m_zeroSpan))
        m_zeroSpan->setValue(oneDigit(restShare * (record.to - record.from)));
    showRows();
    emit changed();
}

// The blow presses where it is largest.
void SignalFields::proposeSign(double signOfPeak) {
    const bool presses = m_use != ImportUse::normalForce;
    proposeChoice(*m_positive, presses && signOfPeak > 0 ? compression : tension);
    emit changed();
}

void SignalFields::proposeTimes(std::optional<RecordSpan> times) {
    if (!m_touched.contains(m_from) && !m_touched.contains(m_to)) showTimes(times);
}

void SignalFields::setTimes(std::optional<RecordSpan> times) {
    m_touched.insert(m_from);
    showTimes(times);
}

void SignalFields::showTimes(std::optional<RecordSpan> times) {
    m_from->setValue(times ? std::optional(times->from) : std::nullopt);
    m_to->setValue(times ? std::optional(times->to) : std::nullopt);
    emit changed();
}

void SignalFields::showRows() {
    const auto zero = static_cast<ZeroLine>(chosenValue(*m_zero));
    const auto scaling = static_cast<Scaling>(chosenValue(*m_scaling));
    setRowVisible(*m_form, *m_place, m_use == ImportUse::normalForce);
    m_gauge->show(static_cast<SignalKind>(chosenValue(*m_kind)));
    setRowVisible(*m_form, *m_zeroSpan, zero == ZeroLine::ofFirstSamples);
    setRowVisible(*m_form, *m_zeroValue, zero == ZeroLine::chosen);
    setRowVisible(*m_form, *m_clip, m_use == ImportUse::blow);
    setRowVisible(*m_form, *m_factor, scaling == Scaling::byFactor);
    setRowVisible(*m_form, *m_impulse, scaling == Scaling::toImpulse);
    if (m_use == ImportUse::rockRecord)
        for (QWidget* row : std::initializer_list<QWidget*>{m_zeroSpan, m_zeroValue, m_factor, m_impulse})
            setRowVisible(*m_form, *row, false);
    // The page finds them out for all gauges of the record.
    for (QWidget* row : std::initializer_list<QWidget*>{m_positive, m_zero, m_from, m_to, m_rangeButtons,
                                                        m_scaling, m_points})
        setRowVisible(*m_form, *row, m_use != ImportUse::rockRecord);
}

// In a rod tension is positive; a hammer and a rock are pressed.
double SignalFields::forcePerNumberNow() const {
    const auto unit = static_cast<std::size_t>(std::max(0, chosenValue(*m_unit)));
    const double size = forcePerNumber(static_cast<SignalKind>(chosenValue(*m_kind)), m_unitList[unit].factor,
                                       m_gauge->bar(barOfScenario()));
    const bool positiveHere = (chosenValue(*m_positive) == tension) == (m_use == ImportUse::normalForce);
    return positiveHere ? size : -size;
}

// Where the gauge is: a blow comes in at the struck end, a force on the rock leaves at the bit.
GaugedBar SignalFields::barOfScenario() const {
    const double share = m_use == ImportUse::normalForce ? place() / chainProperties(m_scenario).length
                         : m_use == ImportUse::blow      ? 0
                                                         : 1;
    const SignalBar at = barAt(m_scenario, share);
    GaugedBar made;
    made.area = *at.area;
    made.axialStiffness = *at.area * *at.modulus;
    made.impedance = *at.impedance;
    return made;
}

void SignalFields::use(const SignalOptions& settings) {
    if (settings.unit) {
        setUnit(settings.unit, settings.unit->kind);
        m_touched.insert(m_unit);
    }
    m_gauge->use(settings, static_cast<SignalKind>(chosenValue(*m_kind)));
    showRows();
    emit changed();
}

void SignalFields::addTo(SignalOptions& settings) const {
    const int unit = chosenValue(*m_unit);
    const auto kind = static_cast<SignalKind>(chosenValue(*m_kind));
    if (unit == noUnit) return;
    if (m_touched.contains(m_unit) || !m_unitIsKnown)
        settings.unit = NamedSignalUnit{kind, m_unitList[static_cast<std::size_t>(unit)]};
    m_gauge->addTo(settings, kind);
}

SignalRecipe SignalFields::recipe() const {
    SignalRecipe recipe;
    recipe.use = m_use == ImportUse::blow ? SignalUse::blow : SignalUse::curve;
    recipe.zeroLine = static_cast<ZeroLine>(chosenValue(*m_zero));
    recipe.zeroSpan = *m_zeroSpan->value();
    recipe.zeroValue = *m_zeroValue->value();
    recipe.forcePerNumber = forcePerNumberNow();
    recipe.from = m_from->value();
    recipe.to = m_to->value();
    const bool clips = m_use == ImportUse::blow && m_clip->isChecked();
    recipe.negatives = clips ? Negatives::clipped : Negatives::kept;
    recipe.scaling = static_cast<Scaling>(chosenValue(*m_scaling));
    recipe.factor = *m_factor->value();
    recipe.impulse = *m_impulse->value();
    recipe.points = static_cast<std::size_t>(m_points->value());
    return recipe;
}

bool SignalFields::leavesPoints() const {
    return !m_touched.contains(m_points);
}

double SignalFields::place() const {
    return m_place->value().value_or(0);
}

QString SignalFields::problem() const {
    if (chosenValue(*m_unit) == noUnit)
        return tr("The header has no known unit: choose the kind of signal and its unit.");
    if (const QString open = m_gauge->problem(static_cast<SignalKind>(chosenValue(*m_kind))); !open.isEmpty())
        return open;
    for (const QuantityField* field : m_fields)
        if (field->isVisibleTo(this) && !field->problem().isEmpty())
            return QStringLiteral("%1: %2").arg(field->accessibleName(), field->problem());
    return m_use == ImportUse::normalForce ? problemOfPlace() : QString();
}

QString SignalFields::problemOfPlace() const {
    if (!m_place->value())
        return tr(
            "place x: not given: type the distance of the gauge from the struck end, because the time of a "
            "wave depends on it");
    const double hammer = hammerProperties(m_scenario.drillString).length;
    if (place() < 0 && hammer == 0) return tr("place x: must not be less than 0, the struck end");
    if (place() < -hammer)
        return tr("place x: must be at least %1, the rear of the hammer")
            .arg(m_units.text(-hammer, UnitKind::length));
    if (!hasUnits(m_scenario)) return {};
    const double length = chainProperties(m_scenario).length;
    if (place() <= length) return {};
    return translated(chainWords(m_scenario).beyondEnd).arg(m_units.text(length, UnitKind::length));
}

}  // namespace drillwave
