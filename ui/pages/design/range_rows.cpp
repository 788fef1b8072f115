// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/range_rows.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "core/model/assignments.h"
#include "core/model/scales.h"
#include "core/model/section_parameter.h"
#include "core/study/design/uncertain_input.h"
#include "core/study/rows/sweep_axis.h"
#include "ui/form/choice_box.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/design/density_mark.h"
#include "ui/pages/study/flow_layout.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/text/shown_text.h"
#include "ui/text/unfocused_wheel.h"

namespace drillwave {
namespace {

constexpr int customaryCount = 11, mostCount = 100;
constexpr int digitsOfEnds = 6;
constexpr int nameLength = 10, kindLength = 6;  // in their boxes
/// A gap that is not known at all, of d0: so far the bit may hang back.
constexpr double unknownGap = 0.4;

/// Keys in the order in which they are proposed: of scenarios with units, and of groups only.
std::vector<std::string_view> usualKeys(RangeUse use, const Scenario& scenario) {
    const bool isUncertain = use == RangeUse::uncertain;
    if (!hasUnits(scenario))
        return isUncertain ? std::vector<std::string_view>{"beta", "gamma", "delta"}
                           : std::vector<std::string_view>{"tau"};
    if (isUncertain) return {"bit_rock.stiffness", "bit_rock.gamma", "bit_rock.gap"};
    return {"pulse.duration", "hammer.1.length", "rod.length", "hammer.velocity"};
}

/// Design variables that are proposed: neither the rock nor constants of steel.
bool isOfDesign(const Parameter& parameter) {
    if (parameter.section() == "bit_rock") return false;
    return std::ranges::none_of(std::array{"youngs_modulus", "density", "yield_strength", "fatigue_strength"},
                                [&](std::string_view end) { return parameter.key.ends_with(end); });
}

/// Parameters that a row can have, in the order in which they are proposed.
std::vector<KeptParameter> proposable(RangeUse use, const Scenario& scenario) {
    std::vector<KeptParameter> found;
    for (const std::string_view key : usualKeys(use, scenario)) found.push_back(findParameter(key));
    if (const KeptParameter size = typicalSize(scenario); size && use == RangeUse::chosen)
        found.push_back(size);
    const auto add = [&](const KeptParameter& parameter) {
        if (use == RangeUse::uncertain || isOfDesign(*parameter)) found.push_back(parameter);
    };
    for (const Parameter& parameter : parameters())
        if (parameter.scope != Scope::manyBlows) add(parameter);
    for (const KeptParameter& parameter : variableSectionParameters(scenario)) add(parameter);
    return found;
}

/// Half as much to half as much again; what is chosen in even steps.
StudyRange rangeOfHalf(const Parameter& parameter, const Scenario& scenario, RangeUse use) {
    const double value = parameter.value(scenario).value_or(0);
    if (!(value > 0)) {
        const bool isGap = parameter.key == "bit_rock.gap" || parameter.key == "delta";
        const double d0 = hasUnits(scenario) ? scalesOf(scenario).penetration : 1;
        return isGap ? StudyRange{parameter, 0, readableNear(parameter, unknownGap * d0), false}
                     : rangeAround(parameter, scenario);
    }
    // Through text, in the unit that is shown: 0.15, not 0.15000000000000002.
    const auto readable = [&](double si) {
        const Unit& unit = parameter.displayUnit();
        return unit.toSi(QString::number(unit.fromSi(si), 'g', digitsOfEnds).toDouble());
    };
    const bool isLogarithmic = use == RangeUse::uncertain && parameter.slider == SliderScale::logarithmic;
    StudyRange range{parameter, readable(value / 2), readable(1.5 * value), isLogarithmic};
    if (!parameter.hard.contains(range.stop)) range.stop = parameter.hard.high;
    return range;
}

}  // namespace

RangeRow::RangeRow(RangeUse use, const UnitChoice& units, QWidget* parent)
    : QWidget(parent),
      m_use(use),
      m_units(units),
      m_parameters(new ChoiceBox(this)),
      m_fields(new QWidget(this)),
      m_remove(new QToolButton(this)) {
    m_parameters->setObjectName(QStringLiteral("parameter"));
    m_parameters->setAccessibleName(use == RangeUse::uncertain ? tr("Uncertain parameter")
                                                               : tr("Design variable"));
    m_parameters->setMinimumContentsLength(nameLength);
    m_parameters->followText();
    auto* layout = new FlowLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* fields = new QHBoxLayout(m_fields);
    fields->setContentsMargins(0, 0, 0, 0);
    fields->setSpacing(4);
    layout->addWidget(m_parameters);
    layout->addWidget(m_fields);
    if (use == RangeUse::uncertain)
        addKind();
    else
        addCount();
    m_remove->setObjectName(QStringLiteral("remove"));
    m_remove->setText(QStringLiteral("✕"));
    m_remove->setAutoRaise(true);
    layout->addWidget(m_remove);
    connect(m_parameters, &QComboBox::currentIndexChanged, this, &RangeRow::choose);
    connect(m_remove, &QToolButton::clicked, this, &RangeRow::removed);
}

void RangeRow::addKind() {
    m_kind = new ChoiceBox(this);
    m_kind->setObjectName(QStringLiteral("kind"));
    m_kind->setAccessibleName(tr("Distribution"));
    m_kind->setMinimumContentsLength(kindLength);
    m_kind->followText();
    for (const QString& kind : {tr("even"), tr("even in log"), tr("normal"), tr("normal in log")})
        m_kind->addItem(kind);
    m_kind->setToolTip(
        tr("Equally likely between the limits, or a normal distribution with 95 % between them; in the value "
           "or in its logarithm"));
    m_density = new DensityMark(this);
    layout()->addWidget(m_kind);
    layout()->addWidget(m_density);
    connect(m_kind, &QComboBox::currentIndexChanged, this, [this](int kind) {
        m_isBell = kind >= 2;
        m_range.logarithmic = kind % 2 == 1;
        follow();
    });
}

void RangeRow::addCount() {
    m_logarithmic = new QCheckBox(tr("log"), this);
    m_logarithmic->setObjectName(QStringLiteral("logarithmic"));
    m_logarithmic->setToolTip(tr("Even ratios instead of even steps"));
    m_count = new QSpinBox(this);
    ignoreUnfocusedWheel(*m_count);
    m_count->setObjectName(QStringLiteral("count"));
    m_count->setAccessibleName(tr("Number of values"));
    m_count->setRange(2, mostCount);
    m_count->setValue(customaryCount);
    m_count->setSuffix(tr(" values"));
    layout()->addWidget(m_logarithmic);
    layout()->addWidget(m_count);
    connect(m_count, &QSpinBox::valueChanged, this, &RangeRow::follow);
    connect(m_logarithmic, &QCheckBox::toggled, this, [this](bool logarithmic) {
        m_range.logarithmic = logarithmic;
        follow();
    });
}

void RangeRow::present(const Scenario& scenario) {
    m_scenario = scenario;
    offerParameters(*m_parameters, scenario);
    chooseParameter(*m_parameters, m_range.parameter);
}

void RangeRow::choose() {
    if (const KeptParameter parameter = chosenParameter(*m_parameters))
        setRange(rangeOfHalf(*parameter, m_scenario, m_use));
}

void RangeRow::setRange(const StudyRange& range) {
    if (range == m_range) return;
    const bool other = range.parameter != m_range.parameter;
    m_range = range;
    chooseParameter(*m_parameters, range.parameter);
    if (other) addFields();
    m_low->setValue(range.start);
    m_high->setValue(range.stop);
    if (m_logarithmic) {
        const QSignalBlocker quiet(m_logarithmic);
        m_logarithmic->setChecked(range.logarithmic);
    }
    if (m_kind) {
        const QSignalBlocker quiet(m_kind);
        m_kind->setCurrentIndex((m_isBell ? 2 : 0) + (range.logarithmic ? 1 : 0));
    }
    follow();
}

// A field is of one quantity for its life.
void RangeRow::addFields() {
    while (QLayoutItem* before = m_fields->layout()->takeAt(0)) {
        if (before->widget()) {
            before->widget()->hide();
            before->widget()->deleteLater();
        }
        delete before;
    }
    m_low = addField(&StudyRange::start, QStringLiteral("low"), tr("from"));
    m_fields->layout()->addWidget(new QLabel(QStringLiteral("…"), m_fields));
    m_high = addField(&StudyRange::stop, QStringLiteral("high"), tr("to"));
    // Both are in the unit that one button chooses.
    if (QToolButton* unit = m_low->unitButton()) unit->hide();
    if (QToolButton* unit = m_high->unitButton()) {
        unit->setAccessibleName(tr("%1, unit").arg(m_high->accessibleName()));
        m_fields->layout()->addWidget(unit);
    }
    setTabOrder(m_parameters, m_low);
    setTabOrder(m_low, m_high);
}

QuantityField* RangeRow::addField(double StudyRange::*end, const QString& name, const QString& words) {
    auto* field = new QuantityField(m_range.parameter, m_units, m_fields);
    field->setObjectName(name);
    field->setAccessibleName(QStringLiteral("%1: %2").arg(parameterName(*m_range.parameter), words));
    field->setTaker([this, end](double si) { return take(end, si); });
    connect(field, &QuantityField::problemShown, this, &RangeRow::changed);
    m_fields->layout()->addWidget(field);
    field->show();
    return field;
}

QString RangeRow::take(double StudyRange::*end, double si) {
    const Message outside = rangeProblem(*m_range.parameter, si);
    if (!outside.isEmpty()) return translated(outside);
    StudyRange range = m_range;
    range.*end = si;
    if (range.start == range.stop) return tr("must differ from the other end");
    if (m_use == RangeUse::uncertain) {
        if (range.start > range.stop) return tr("the range is reversed: give the lower end first");
        // In the words of the command, which refuses what has no logarithm, or a bell that reaches zero.
        const StudyRange before = std::exchange(m_range, range);
        const ParsedUncertain parsed = parseUncertain(text());
        m_range = before;
        if (!parsed.problem.isEmpty()) return translated(withTitles(parsed.problem));
    }
    m_range = range;
    follow();
    return {};
}

void RangeRow::setRemovable(bool removable) {
    m_remove->setVisible(removable);
}

std::string RangeRow::text() const {
    if (m_use == RangeUse::chosen) {
        const auto count = m_range.pointsWithin(static_cast<std::uint64_t>(m_count->value()));
        return m_range.text() + ":" + std::to_string(count) + m_range.tail();
    }
    return m_range.text() + (m_isBell ? m_range.logarithmic ? ":lognormal" : ":normal" : m_range.tail());
}

bool RangeRow::setText(const std::string& text) {
    StudyRange range;
    bool isBell = false;
    int count = customaryCount;
    if (m_use == RangeUse::uncertain) {
        using enum DistributionKind;
        const ParsedUncertain parsed = parseUncertain(text);
        if (!parsed.problem.isEmpty() || parsed.input.kind == percent) return false;
        const DistributionKind kind = parsed.input.kind;
        isBell = kind == normal || kind == lognormal;
        range = {parsed.input.parameter, parsed.input.low, parsed.input.high,
                 kind == log || kind == lognormal};
    } else {
        const ParsedAxis parsed = parseAxis(text);
        const SweepAxis& axis = parsed.axis;
        const bool isRange =
            axis.kind == SweepAxis::Kind::linear || axis.kind == SweepAxis::Kind::logarithmic;
        if (!parsed.problem.isEmpty() || !isRange || axis.count < 2 || axis.count > mostCount) return false;
        count = static_cast<int>(axis.count);
        range = {axis.parameter, axis.start, axis.stop, axis.kind == SweepAxis::Kind::logarithmic};
    }
    if (!range.parameter->applies(m_scenario) || m_parameters->count() == 0) return false;
    m_isBell = isBell;
    if (m_count) {
        const QSignalBlocker quiet(m_count);
        m_count->setValue(count);
    }
    setRange(range);
    follow();
    return m_range == range;
}

QString RangeRow::problem() const {
    for (const QuantityField* field : {m_low, m_high})
        if (field && !field->problem().isEmpty())
            return QStringLiteral("%1: %2").arg(field->accessibleName(), field->problem());
    return {};
}

void RangeRow::follow() {
    if (!m_range.parameter) return;
    m_remove->setAccessibleName(tr("Remove %1").arg(parameterName(*m_range.parameter)));
    m_remove->setToolTip(m_use == RangeUse::uncertain ? tr("Removes this row: the parameter is known")
                                                      : tr("Removes this row: the parameter is not varied"));
    if (m_density) {
        const ParsedUncertain parsed = parseUncertain(text());
        m_density->setVisible(parsed.problem.isEmpty());
        if (parsed.problem.isEmpty()) m_density->present(parsed.input.in(m_scenario));
    }
    emit changed();
}

RangeRows::RangeRows(RangeUse use, const QString& words, std::size_t least, std::size_t most,
                     const UnitChoice& units, QWidget* parent)
    : QWidget(parent),
      m_use(use),
      m_units(units),
      m_layout(new QVBoxLayout(this)),
      m_add(new QToolButton(this)),
      m_rows(*m_layout, *m_add, least, most) {
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(2);
    m_add->setObjectName(QStringLiteral("add"));
    m_add->setText(QStringLiteral("+"));
    m_add->setAccessibleName(use == RangeUse::uncertain ? tr("Add an uncertain parameter")
                                                        : tr("Add a design variable"));
    m_add->setToolTip(use == RangeUse::uncertain ? tr("Adds an uncertain parameter")
                                                 : tr("Adds a design variable"));
    auto* heading = new QHBoxLayout;
    heading->addWidget(new QLabel(words, this));
    heading->addWidget(m_add);
    heading->addStretch(1);
    m_layout->addLayout(heading);
    connect(m_add, &QToolButton::clicked, this, &RangeRows::add);
}

void RangeRows::present(const Scenario& scenario) {
    m_scenario = scenario;
    const auto applies = [&](const RangeRow* row) {
        return row->range().parameter && row->range().parameter->applies(scenario);
    };
    if (!m_isProposed || !std::ranges::all_of(rows(), applies)) return propose();
    for (RangeRow* row : rows()) row->present(scenario);
}

std::vector<std::string> RangeRows::texts() const {
    std::vector<std::string> texts;
    for (const RangeRow* row : rows()) texts.push_back(row->text());
    for (const auto& [text, line] : m_texts) texts.push_back(text);
    return texts;
}

void RangeRows::setTexts(const std::vector<std::string>& texts) {
    const QSignalBlocker quiet(this);
    m_isProposed = true;
    m_rows.clear();
    clearTexts();
    for (const std::string& text : texts) {
        if (m_rows.isFull()) {
            appendText(text);
            continue;
        }
        RangeRow* row = append({});
        if (row->setText(text)) continue;
        m_rows.removeLast();
        appendText(text);
    }
}

void RangeRows::appendText(const std::string& text) {
    auto* line = new QWidget(this);
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(QString::fromStdString(text), line);
    label->setTextFormat(Qt::PlainText);
    auto* button = new QToolButton(line);
    button->setObjectName(QStringLiteral("removeText"));
    button->setText(QStringLiteral("✕"));
    button->setAutoRaise(true);
    button->setAccessibleName(tr("Remove %1").arg(label->text()));
    layout->addWidget(label);
    layout->addWidget(button);
    layout->addStretch(1);
    m_layout->addWidget(line);
    line->show();
    m_texts.emplace_back(text, line);
    connect(button, &QToolButton::clicked, this, [this, line] {
        std::erase_if(m_texts, [&](const auto& each) { return each.second == line; });
        line->hide();
        line->deleteLater();
        emit changed();
    });
}

void RangeRows::clearTexts() {
    for (const auto& [text, line] : m_texts) {
        line->hide();
        line->deleteLater();
    }
    m_texts.clear();
}

bool RangeRows::isExcluded(std::string_view key) const {
    return std::ranges::any_of(m_excluded, [&](const std::string& other) { return areRivals(other, key); });
}

bool RangeRows::exclude(std::vector<std::string> keys) {
    m_excluded = std::move(keys);
    std::vector<std::string> kept;
    bool hasExcluded = false;
    for (const RangeRow* row : rows()) {
        if (isExcluded(row->range().parameter->key))
            hasExcluded = true;
        else
            kept.push_back(row->text());
    }
    for (const auto& [text, line] : m_texts) kept.push_back(text);
    if (hasExcluded) setTexts(kept);
    return hasExcluded;
}

QString RangeRows::problem() const {
    for (const RangeRow* row : rows())
        if (QString problem = row->problem(); !problem.isEmpty()) return problem;
    return {};
}

// The first that is not there; with at most so many rows as there are, one is always left.
StudyRange RangeRows::proposal() const {
    const auto isThere = [&](std::string_view key) {
        return std::ranges::any_of(rows(), [&](const RangeRow* row) {
            return row->range().parameter->key == key || areRivals(row->range().parameter->key, key);
        });
    };
    const std::vector<std::string_view> usual = usualKeys(m_use, m_scenario);
    const auto hasValue = [&](const Parameter& parameter) {  // a gap that is 0 is uncertain all the same
        return std::ranges::find(usual, parameter.key) != usual.end() ||
               parameter.value(m_scenario).value_or(0) > 0;
    };
    for (const KeptParameter& parameter : proposable(m_use, m_scenario))
        if (parameter && parameter->applies(m_scenario) && !isThere(parameter->key) &&
            !isExcluded(parameter->key) && hasValue(*parameter))
            return rangeOfHalf(*parameter, m_scenario, m_use);
    return {};
}

void RangeRows::propose() {
    m_isProposed = true;
    const QSignalBlocker quiet(this);
    m_rows.clear();
    clearTexts();
    const std::size_t usual = m_use == RangeUse::uncertain ? 3 : 1;
    for (std::size_t i = 0; i < usual; ++i) append(proposal());
}

void RangeRows::add() {
    if (m_rows.isFull()) return;
    append(proposal());
    if (QWidget* first = rows().back()->findChild<QWidget*>(QStringLiteral("parameter"));
        first && isVisible())
        first->setFocus();
    emit changed();
}

RangeRow* RangeRows::append(const StudyRange& range) {
    auto* row = new RangeRow(m_use, m_units, this);
    row->present(m_scenario);
    if (range.parameter) row->setRange(range);
    connect(row, &RangeRow::changed, this, &RangeRows::changed);
    m_rows.append(row, [this] { emit changed(); });
    return row;
}

}  // namespace drillwave
