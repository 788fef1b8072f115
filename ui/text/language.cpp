// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QPointer>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "ui/text/number_text.h"
#include "ui/text/settings.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {

namespace {

const QString languageKey = QStringLiteral("language");

thread_local int wantingEnglish = 0;
const Language* spoken = &languages[0];

QString codeOf(const Language& language) {
    return fromView(language.code);
}

// Sentences use other units for a rod than for the motion of the bit; the size decides.
std::optional<UnitKind> kindOf(double si, Quantity quantity) {
    constexpr double leastOfRods = 0.3;   // [m]
    constexpr double leastModulus = 5e9;  // [Pa]
    switch (quantity) {
        case Quantity::length:
            return std::abs(si) < leastOfRods ? UnitKind::penetration : UnitKind::length;
        case Quantity::stress:
            return std::abs(si) < leastModulus ? UnitKind::stress : UnitKind::modulus;
        default:
            break;
    }
    const auto found = std::ranges::find(unitKinds(), quantity, &UnitKindRow::quantity);
    return found == unitKinds().end() ? std::nullopt : std::optional(found->kind);
}

}  // namespace

const Language* chosenLanguage() {
    return findLanguage(Settings().value(languageKey).toString().toStdString());
}

void chooseLanguage(const Language* language) {
    if (language)
        Settings().setValue(languageKey, codeOf(*language));
    else
        Settings().remove(languageKey);
}

const Language& firstLanguage(const QStringList& wanted) {
    for (const QString& each : wanted) {
        const QString code = each.section(u'-', 0, 0).section(u'_', 0, 0);
        if (const Language* found = findLanguage(code.toStdString())) return *found;
    }
    return languages[0];
}

const Language& languageToSpeak() {
    const Language* chosen = chosenLanguage();
    return chosen ? *chosen : firstLanguage(QLocale::system().uiLanguages());
}

EnglishTexts::EnglishTexts() {
    ++wantingEnglish;
}

EnglishTexts::~EnglishTexts() {
    --wantingEnglish;
}

bool EnglishTexts::areWanted() {
    return wantingEnglish > 0;
}

Catalogue::Catalogue(const Language& language, QObject* parent) : QTranslator(parent) {
    // English has no file; its texts are those of the sources.
    if (isEnglish(language)) return;
    const bool loaded = load(QStringLiteral(":/languages/drillwave_%1.qm").arg(codeOf(language)));
    Q_ASSERT(loaded);
    Q_UNUSED(loaded);
}

QString Catalogue::translate(const char* context, const char* source, const char* disambiguation,
                             int count) const {
    if (EnglishTexts::areWanted()) return {};
    return QTranslator::translate(context, source, disambiguation, count);
}

void speak(const Language& language) {
    // Their destructors remove them if another language was spoken before.
    static QPointer<QTranslator> ofQt, ours;
    delete ofQt;
    delete ours;
    // The translator of Qt goes first, so that those of its texts that ours translates are found in ours.
    ofQt = new QTranslator(qApp);
    if (ofQt->load(QStringLiteral("qtbase_") + codeOf(language),
                   QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(ofQt);
    ours = new Catalogue(language, qApp);
    QCoreApplication::installTranslator(ours);
    spoken = &language;
}

const Language& spokenLanguage() {
    return EnglishTexts::areWanted() ? languages[0] : *spoken;
}

LocalStyle::LocalStyle(const QLocale& locale, UnitSystem system, ChosenUnits chosen)
    : m_locale(locale), m_system(system), m_chosen(std::move(chosen)) {}

LocalStyle LocalStyle::of(const UnitChoice& units) {
    return {QLocale(), units.physicalSystem(), units.chosen()};
}

std::string LocalStyle::number(double value, int digits) const {
    return numberText(value, digits, m_locale).toStdString();
}

std::string LocalStyle::magnitude(double value) const {
    return magnitudeText(value, m_locale).toStdString();
}

ReadUnit LocalStyle::unitFor(double si, Quantity quantity) const {
    return unitOf(kindOf(si, quantity), si, quantity);
}

ReadUnit LocalStyle::rateUnit(double si) const {
    ReadUnit read = unitOf(UnitKind::rate, si, Quantity::velocity);
    if (m_chosen.contains(UnitKind::rate) || m_system == UnitSystem::us) return read;
    read.unit = &handyUnit(UnitKind::rate, std::abs(si), UnitSystem::si);
    read.name = shownUnitName(read.unit->name).toStdString();
    return read;
}

ReadUnit LocalStyle::unitOf(std::optional<UnitKind> kind, double si, Quantity quantity) const {
    ReadUnit read = ReadingStyle::unitFor(si, quantity);
    if (kind) {
        const auto own = m_chosen.find(*kind);
        if (own != m_chosen.end())
            read.unit = own->second;
        else if (m_system == UnitSystem::us)
            read.unit = &handyUnit(*kind, std::abs(si), m_system);
    }
    read.name = shownUnitName(read.unit->name).toStdString();
    return read;
}

Message LocalStyle::unitsTitle() const {
    if (!m_chosen.empty()) return translatable("with its unit");
    if (m_system == UnitSystem::us) return translatable("in US units");
    return ReadingStyle::unitsTitle();
}

std::string LocalStyle::patternFor(const std::string& english) const {
    return translatedPattern(english);
}

std::string LocalStyle::language() const {
    return std::string(spokenLanguage().code);
}

}  // namespace drillwave
