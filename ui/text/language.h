// SPDX-License-Identifier: GPL-3.0-or-later
// Language of the window and its translated texts. Files are written in English, except reports.
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

/// Returns the language chosen by the user; nullptr for that of the system.
const Language* chosenLanguage();
/// Stores the language that the user has chosen, for windows opened from now on. nullptr means the language
/// of the system.
void chooseLanguage(const Language* language);

/// Returns the first of the `wanted` languages ("de-AT", "sv", "C", as in QLocale::uiLanguages()) for which
/// there is a translation; English if there is none.
const Language& firstLanguage(const QStringList& wanted);
/// Returns the language chosen by the user, else the one preferred by the system.
const Language& languageToSpeak();

/// Switch to English texts in the present thread, for the lifetime of an object, for example to write files.
class EnglishTexts {
  public:
    EnglishTexts();
    ~EnglishTexts();
    EnglishTexts(const EnglishTexts&) = delete;
    EnglishTexts& operator=(const EnglishTexts&) = delete;

    static bool areWanted();
};

/// Translated texts of a language, compiled by lrelease from resources/languages.
class Catalogue : public QTranslator {
    Q_OBJECT

  public:
    /// Loads the texts of a language; for English, which needs no translation, it stays empty.
    explicit Catalogue(const Language& language, QObject* parent = nullptr);

    /// Returns the translation of a text; empty while an object of type EnglishTexts exists.
    QString translate(const char* context, const char* source, const char* disambiguation = nullptr,
                      int count = -1) const override;
};

/// Sets the language of the application's texts, and of Qt's own texts if their translation is installed.
void speak(const Language& language);
/// Returns the language set by speak(). It is English before the first call, and while an object of type
/// EnglishTexts exists.
const Language& spokenLanguage();

// Sentences and tables of the core library in the language, number format and units of the window.

/// Style of sentences: words in the language of the window and numbers as in numberText(). Values are in SI
/// or US units, or in units chosen for single kinds.
class LocalStyle : public ReadingStyle {
  public:
    /// Makes a style. A dimensionless `system` counts as SI, because sentences have no dimensionless values.
    LocalStyle(const QLocale& locale, UnitSystem system, ChosenUnits chosen);

    /// Returns the present style of the window, from QLocale() and the chosen units.
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
