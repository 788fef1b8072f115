// SPDX-License-Identifier: GPL-3.0-or-later
// Names of enumerations. That a value without a name does not compile is the test enum_names_refuse.
#include <QTest>

#include "core/text/enum_names.h"

using namespace drillwave;

namespace {

enum class Lonely { only };
enum class Season { spring, summer, autumn, winter };
enum class Sized : std::size_t { small, large };

struct Rock {
    enum class Kind { hard, soft };
};

constexpr EnumNames<Season> seasons{{{Season::spring, "spring"},
                                     {Season::summer, "summer"},
                                     {Season::autumn, "fall"},
                                     {Season::winter, "fall"}}};

}  // namespace

class TestEnumNames : public QObject {
    Q_OBJECT

  private slots:
    // Counted wherever the enumeration stands: unnamed here, in a class, with a type of its own.
    void theCompilerCountsTheValues() {
        static_assert(valueCount<Lonely> == 1);
        static_assert(valueCount<Season> == 4);
        static_assert(valueCount<Sized> == 2);
        static_assert(valueCount<Rock::Kind> == 2);
        static_assert(!isEnumerator<static_cast<Season>(4)>());
        static_assert(!isEnumerator<static_cast<Season>(-1)>());
        static_assert(allValues<Season>.back() == Season::winter);
    }

    void eachValueHasItsName() {
        QCOMPARE(seasons[Season::spring], std::string_view("spring"));
        QCOMPARE(seasons[Season::winter], std::string_view("fall"));
        QCOMPARE(seasons.all().size(), std::size_t{4});
        QCOMPARE(seasons.all()[1], std::string_view("summer"));
    }

    void aNameFindsItsFirstValue() {
        QVERIFY(seasons.find("summer") == Season::summer);
        QVERIFY(seasons.find("fall") == Season::autumn);
        QVERIFY(!seasons.find("Summer"));
        QVERIFY(!seasons.find(""));
    }
};

QTEST_APPLESS_MAIN(TestEnumNames)
#include "tst_enum_names.moc"
