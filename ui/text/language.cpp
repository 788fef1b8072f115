// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QPointer>

#include "ui/text/settings.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

const QString languageKey = QStringLiteral("language");

thread_local int wantingEnglish = 0;
const Language* spoken = &languages[0];

QString codeOf(const Language& language) {
    return fromView(language.code);
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
    // They take themselves away where another language was spoken before.
    static QPointer<QTranslator> ofQt, ours;
    delete ofQt;
    delete ours;
    // That of Qt goes first, so that what ours has of its texts is found before.
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

}  // namespace drillwave
