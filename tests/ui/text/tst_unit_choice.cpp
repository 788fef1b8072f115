// SPDX-License-Identifier: GPL-3.0-or-later
// Units chosen by the user: only of their owner, and kept for the next.
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/model/law_parameter.h"
#include "core/model/parameter.h"
#include "tests/support/window.h"
#include "ui/text/settings.h"
#include "ui/text/unit_choice.h"

using namespace drillwave;

class TestUnitChoice : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        test::keepSettingsIn(m_folder.path());
    }
    void init() { Settings().clear(); }

    void twoOwnersDoNotInfluenceEachOther() {
        UnitChoice first, second;
        const QSignalSpy firstChanged(&first, &UnitChoice::changed);
        const QSignalSpy secondChanged(&second, &UnitChoice::changed);
        first.choose(UnitSystem::us);
        first.choose(UnitKind::force, findUnit(Quantity::force, "N"));
        first.chooseForField(rodLength(), *findUnit(Quantity::length, "cm"));
        QCOMPARE(firstChanged.count(), 2);
        QCOMPARE(first.fieldUnit(rodLength()).name, std::string_view("cm"));
        QCOMPARE(secondChanged.count(), 0);
        QCOMPARE(second.system(), UnitSystem::si);
        QVERIFY(second.chosen().empty());
        QCOMPARE(second.fieldUnit(rodLength()).name, std::string_view("m"));
        // Nor does what the second does later: the first stays, whatever is kept.
        second.choose(UnitSystem::dimensionless);
        QCOMPARE(firstChanged.count(), 2);
        QCOMPARE(first.system(), UnitSystem::us);
    }

    void theNextOwnerBeginsWithWhatWasChosenLast() {
        UnitChoice before;
        before.choose(UnitSystem::us);
        before.choose(UnitKind::force, findUnit(Quantity::force, "N"));
        before.chooseForField(rodLength(), *findUnit(Quantity::length, "cm"));
        const UnitChoice next;
        QCOMPARE(next.system(), UnitSystem::us);
        QCOMPARE(next.physicalSystem(), UnitSystem::us);
        QCOMPARE(next.unitFor(UnitKind::force, 1e5).name, std::string_view("N"));
        QCOMPARE(next.fieldUnit(rodLength()).name, std::string_view("cm"));
    }

    void aUnitOfAFieldIsNoUnitOfTheRatioOfThatKey() {
        UnitChoice units;
        const KeptParameter penetration = findParameter("bit_rock.reference_penetration");
        units.chooseForField(*penetration, *findUnit(Quantity::length, "cm"));
        QCOMPARE(units.fieldUnit(*penetration).name, std::string_view("cm"));
        QCOMPARE(units.fieldUnit(*inScales(*penetration)).name, std::string_view());
    }

    void aTextIsInTheUnitInWhichItIsBestRead() {
        UnitChoice units;
        const auto text = [&](double si, UnitKind kind) {
            return units.text(si, kind).replace(QChar(QChar::Nbsp), QLatin1Char(' '));
        };
        QCOMPARE(text(255.4e3, UnitKind::force), QStringLiteral("255 kN"));
        QCOMPARE(text(-2e-4, UnitKind::time), QStringLiteral("−200 µs"));
        units.choose(UnitKind::force, findUnit(Quantity::force, "N"));
        QCOMPARE(text(1234, UnitKind::force), QStringLiteral("1234 N"));
        QCOMPARE(units.boundText(1231, UnitKind::force), QStringLiteral("1240") + QChar(QChar::Nbsp) + u'N');
    }

  private:
    static const Parameter& rodLength() { return *findParameter("rod.length"); }

    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestUnitChoice)
#include "tst_unit_choice.moc"
