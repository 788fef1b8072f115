// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/law_section.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <utility>

#include "core/contact/bit_rock_law.h"
#include "core/model/law_parameter.h"
#include "ui/form/choice_box.h"
#include "ui/form/parameter_row.h"
#include "ui/form/quantity_field.h"

namespace drillwave {
namespace {

/// Force of a proposed corner, relative to the last one.
constexpr double nextCorner = 1.5;

}  // namespace

LawSection::LawSection(Document& document, QGridLayout* grid, QWidget* parent)
    : QObject(parent),
      m_document(document),
      m_law(new ChoiceBox(parent)),
      m_corners(new QWidget(parent)),
      m_lines(new QVBoxLayout(m_corners)),
      m_add(new QToolButton(m_corners)),
      m_gesture(document.newGesture()) {
    auto* label = new QLabel(tr("force–penetration"), parent);
    label->setBuddy(m_law);
    m_law->setObjectName(QStringLiteral("bit_rock.law"));
    m_law->setAccessibleName(tr("Bit and rock: law"));
    m_law->setToolTip(
        tr("Rise of the force with penetration: along a line, along lines with corners, or as a power; "
           "unloading always follows one slope"));
    for (const QString& name : {tr("linear"), tr("corners"), tr("power")}) m_law->addItem(name);
    const int row = grid->rowCount();
    grid->addWidget(label, row, 0);
    grid->addWidget(m_law, row, 1, 1, formColumns - 1);
    m_lines->setContentsMargins(0, 0, 0, 0);
    m_lines->setSpacing(3);
    m_add->setObjectName(QStringLiteral("addCorner"));
    m_add->setText(tr("+ corner"));
    m_lines->addWidget(m_add, 0, Qt::AlignLeft);
    grid->addWidget(m_corners, row + 1, 0, 1, formColumns);
    connect(m_law, &QComboBox::activated, this, [this](int law) { choose(static_cast<RockLaw>(law)); });
    connect(m_add, &QToolButton::clicked, this, &LawSection::addCorner);
}

void LawSection::present(const Scenario& scenario) {
    const BitRock& rock = scenario.bitRock;
    {
        const QSignalBlocker quiet(m_law);
        m_law->setCurrentIndex(static_cast<int>(rock.law));
    }
    const bool hasCorners = rock.law == RockLaw::corners;
    if (std::exchange(m_form, scenario.form) != scenario.form) setCornerCount(0);  // other units
    setCornerCount(hasCorners ? rock.corners.size() : 0);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_rows[i].force->setValue(rock.corners[i].force);
        m_rows[i].slope->setValue(rock.corners[i].slope);
    }
    m_corners->setVisible(hasCorners);
    m_add->setEnabled(rock.corners.size() < mostLawCorners);
}

void LawSection::choose(RockLaw law) {
    const Scenario& scenario = m_document.scenario();
    if (law != scenario.bitRock.law) change(proposedRock(scenario, law), tr("change the law of the rock"));
}

void LawSection::change(const BitRock& rock, const QString& step) {
    Scenario changed = m_document.scenario();
    changed.bitRock = rock;
    m_document.useScenario(changed, step);
    present(m_document.scenario());  // where it was not taken, what there was
}

void LawSection::setCornerCount(std::size_t count) {
    while (m_rows.size() > count) {
        m_rows.back().box->hide();
        m_rows.back().box->deleteLater();
        m_rows.pop_back();
    }
    while (m_rows.size() < count) {
        const std::size_t corner = m_rows.size();
        auto* box = new QWidget(m_corners);
        auto* line = new QHBoxLayout(box);
        line->setContentsMargins(0, 0, 0, 0);
        line->setSpacing(4);
        line->addWidget(new QLabel(tr("from"), box));
        QuantityField* force = addField(corner, "force", tr("force"), box);
        line->addWidget(force);
        if (QToolButton* unit = force->unitButton())
            line->addWidget(unit);
        else
            line->addWidget(new QLabel(QStringLiteral("F₀"), box));
        line->addWidget(new QLabel(tr("slope"), box));
        QuantityField* slope = addField(corner, "slope", tr("slope, of k"), box);
        line->addWidget(slope);
        auto* away = new QToolButton(box);
        away->setText(QStringLiteral("✕"));
        away->setAutoRaise(true);
        away->setAccessibleName(tr("Remove corner %1").arg(corner + 1));
        connect(away, &QToolButton::clicked, this, [this, corner] { removeCorner(corner); });
        line->addWidget(away);
        line->addStretch(1);
        m_lines->insertWidget(m_lines->count() - 1, box);
        box->show();
        m_rows.push_back({box, force, slope});
    }
}

QuantityField* LawSection::addField(std::size_t corner, const char* part, const QString& words,
                                    QWidget* row) {
    const std::string key = "bit_rock.corner." + std::to_string(corner + 1) + "." + part;
    const KeptParameter parameter = inFormOf(m_document.scenario(), *findParameter(key));
    auto* field = new QuantityField(parameter, m_document.units(), row);
    field->setObjectName(QString::fromStdString(key));
    field->setAccessibleName(tr("Corner %1: %2").arg(corner + 1).arg(words));
    field->setTaker([this, parameter](double si) { return m_document.assign(*parameter, si, m_gesture); });
    connect(field, &QuantityField::editsEnded, this, [this] { m_gesture = m_document.newGesture(); });
    return field;
}

void LawSection::addCorner() {
    BitRock rock = m_document.scenario().bitRock;
    const RockCorner last = rock.corners.back();
    rock.corners.push_back({nextCorner * last.force, last.slope});
    change(rock, tr("add a corner to the law of the rock"));
}

void LawSection::removeCorner(std::size_t corner) {
    BitRock rock = m_document.scenario().bitRock;
    if (corner >= rock.corners.size()) return;
    rock.corners.erase(rock.corners.begin() + static_cast<std::ptrdiff_t>(corner));
    if (rock.corners.empty()) rock.law = RockLaw::bilinear;
    change(rock, tr("remove a corner from the law of the rock"));
}

}  // namespace drillwave
