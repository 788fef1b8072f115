// SPDX-License-Identifier: GPL-3.0-or-later
// The language of the window: which one it is, and its texts. Files are in English, but for reports.
#pragma once

#include <QLocale>
#include <QStringList>
#include <QTranslator>
#include <optional>

#include "core/text/handy_text.h"
#include "core/text/languages.h"
#include "ui/text/unit_kind.h"

namespace drillwave {

class UnitChoice;

/// The language chosen by the user; nullptr for that of the system.
const Language* chosenLanguage();
/// Sets the language of windows opened from now on.
void chooseLanguage(const Language* language);

/// The first of the wanted ("de-AT", "sv", "C") that there is, in the order in which a user prefers them
/// (QLocale::uiLanguages()); English where none is.
const Language& firstLanguage(const QStringList& wanted);
/// The chosen language, else the one preferred by the system.
const Language& languageToSpeak();

/// While one lives, its thread has the texts of the program in English whatever the window speaks: for files.
class EnglishTexts {
  public:
    EnglishTexts();
    ~EnglishTexts();
    EnglishTexts(const EnglishTexts&) = delete;
    EnglishTexts& operator=(const EnglishTexts&) = delete;

    static bool areWanted();
};

/// The texts of a language, as lrelease makes them of resources/languages.
class Catalogue : public QTranslator {
    Q_OBJECT

  public:
    /// Empty for English, which needs none.
    explicit Catalogue(const Language& language, QObject* parent = nullptr);

    /// Returns nothing while EnglishTexts exist.
    QString translate(const char* context, const char* source, const char* disambiguation = nullptr,
                      int count = -1) const override;
};

/// Gives the application its texts in that language, and Qt its own if they are installed.
void speak(const Language& language);
/// Returns that language; English before speak(), and while EnglishTexts exist.
const Language& spokenLanguage();

// Sentences and tables of the core in the words, numbers and units of the one at the window.

/// Words in the language that is spoken, numbers as numberText() writes them, in SI or US units or those
/// chosen by kind.
class LocalStyle : public ReadingStyle {
  public:
    /// `system` counts as SI if it is dimensionless, because sentences have no dimensionless values.
    LocalStyle(const QLocale& locale, UnitSystem system, ChosenUnits chosen);

    /// Returns the style of the window as it is now: QLocale() and the chosen units.
    static LocalStyle of(const UnitChoice& units);

    std::string number(double value, int digits) const override;
    std::string magnitude(double value) const override;
    ReadUnit unitFor(double si, Quantity quantity) const override;
    ReadUnit rateUnit(double si) const override;
    bool isPrinted() const override { return true; }
    bool keepsUnitsOfFile() const override { return false; }
    Message unitsTitle() const override;
    std::string patternFor(const std::string& english) const override;
    std::string language() const override;

  private:
    ReadUnit unitOf(std::optional<UnitKind> kind, double si, Quantity quantity) const;

    QLocale m_locale;
    UnitSystem m_system;
    ChosenUnits m_chosen;
};

}  // namespace drillwave
