// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window/monkey.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPointer>
#include <QTest>
#include <QTimer>
#include <QUrl>
#include <QWheelEvent>
#include <QWindow>

#include "ui/window/page_tabs.h"

namespace drillwave {
namespace {

constexpr int nestedWatchMs = 5;
constexpr int nestedPatience = 1000;  // tries, five seconds

const Qt::Key keys[] = {
    Qt::Key_Tab,  Qt::Key_Backtab, Qt::Key_Return, Qt::Key_Escape, Qt::Key_Backspace, Qt::Key_Delete,
    Qt::Key_Left, Qt::Key_Right,   Qt::Key_Up,     Qt::Key_Down,   Qt::Key_PageUp,    Qt::Key_PageDown,
    Qt::Key_Home, Qt::Key_End,     Qt::Key_Space,  Qt::Key_Plus,   Qt::Key_Minus,     Qt::Key_A,
    Qt::Key_B,    Qt::Key_C,       Qt::Key_V,      Qt::Key_X,      Qt::Key_Z,         Qt::Key_Y,
    Qt::Key_S,    Qt::Key_O,       Qt::Key_N,      Qt::Key_D,      Qt::Key_I,         Qt::Key_0,
    Qt::Key_1,    Qt::Key_5,       Qt::Key_Period, Qt::Key_Comma,  Qt::Key_E,         Qt::Key_F,
    Qt::Key_F6,   Qt::Key_F10,     Qt::Key_Menu,   Qt::Key_Q,      Qt::Key_F1,        Qt::Key_F5,
    Qt::Key_F7,   Qt::Key_F2,      Qt::Key_W,
};

const char* const typedTexts[] = {
    "0.5",    "1e3",     "3,2",   "38 mm", "1.5 in", "4.27 m", "-1",   "0",         "1e308",  "1e-300",
    "nan",    "inf",     "1.2.3", "3 kN",  "200 us", "µ",      "",     "1.234,5",   "12 ft",  "210 GPa",
    "0.9999", "1 000 m", "−2",    "7850",  "1e9",    "10",     "0x10", "rod of 3m", "%n%1%s", "99999999999",
};

bool isShown(const QWidget* widget) {
    return widget->isVisible() && widget->width() > 1 && widget->height() > 1;
}

bool takesFocus(const QWidget* widget) {
    return isShown(widget) && widget->isEnabled() && widget->focusPolicy() != Qt::NoFocus;
}

QString nameOf(const QWidget* widget) {
    if (!widget) return QStringLiteral("nothing");
    return QLatin1String(widget->metaObject()->className()) + QLatin1Char(' ') + widget->objectName();
}

}  // namespace

Monkey::Monkey(quint32 seed, ScriptedAnswers& answers, MonkeyFiles& files)
    : m_random(seed), m_nestedRandom(seed), m_answers(answers), m_files(files) {}

void Monkey::act(QWidget& window) {
    struct Habit {
        int weight;
        void (Monkey::*act)(QWidget&);
    };
    static constexpr Habit habits[] = {
        {200, &Monkey::pressKey},     {120, &Monkey::typeText},     {220, &Monkey::click},
        {100, &Monkey::drag},         {120, &Monkey::turnWheel},    {40, &Monkey::choosePage},
        {80, &Monkey::triggerAction}, {60, &Monkey::undoOrRedo},    {12, &Monkey::drop},
        {12, &Monkey::resize},        {4, &Monkey::changeColours},  {2, &Monkey::changeFont},
        {6, &Monkey::changeFiles},    {4, &Monkey::loseActivation},
    };
    int sum = 0;
    for (const Habit& habit : habits) sum += habit.weight;
    int drawn = upTo(sum);
    const Habit* habit = habits;
    while (drawn >= habit->weight) drawn -= (habit++)->weight;

    prepareAnswers();
    m_acting = true;
    ++m_acts;
    watchNestedLoop(m_acts, 0);
    (this->*habit->act)(window);
    QCoreApplication::processEvents();
    m_acting = false;
}

void Monkey::prepareAnswers() {
    static constexpr Questions::Unsaved unsaved[] = {Questions::Unsaved::discard, Questions::Unsaved::discard,
                                                     Questions::Unsaved::save, Questions::Unsaved::cancel};
    m_answers.unsaved = any(unsaved);
    m_answers.open = oneIn(4) ? QString() : any(m_files.toOpen());
    m_answers.import = oneIn(4) ? QString() : any(m_files.toOpen());
    m_answers.import = oneIn(4) ? QString() : any(m_files.toOpen());
    m_answers.save = oneIn(4) ? QString() : any(m_files.toSave());
    m_answers.exportTo = oneIn(4) ? QString() : any(m_files.toExport());
    m_answers.folder = oneIn(4) ? QString() : any(m_files.toExport());
    m_answers.confirm = oneIn(2);
    m_answers.picture = oneIn(4) ? std::nullopt : std::optional<PictureChoice>(PictureChoice{});
    m_answers.confirmed.clear();
    m_answers.found.clear();
    m_answers.told.clear();
}

void Monkey::pressKey(QWidget& window) {
    QWidget* target = QApplication::activePopupWidget();
    if (!target && oneIn(3)) {
        if (QWidget* widget = anyWidget(window, takesFocus)) widget->setFocus(Qt::OtherFocusReason);
    }
    if (!target) target = QApplication::focusWidget() ? QApplication::focusWidget() : &window;
    const Qt::Key key = any(keys);
    const Qt::KeyboardModifiers modifiers = anyModifiers();
    note(QStringLiteral("key %1 at %2").arg(QKeySequence(modifiers | key).toString(), nameOf(target)));
    QTest::keyClick(target, key, modifiers);
}

void Monkey::typeText(QWidget& window) {
    QWidget* field = anyWidget(window, [](const QWidget* widget) {
        return takesFocus(widget) && (widget->inherits("QLineEdit") || widget->inherits("QAbstractSpinBox"));
    });
    if (!field) return;
    const QString text = QString::fromUtf8(any(typedTexts));
    note(QStringLiteral("type \"%1\" into %2").arg(text, nameOf(field)));
    field->setFocus(Qt::MouseFocusReason);
    if (!oneIn(4)) QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    if (oneIn(4)) {
        QApplication::clipboard()->setText(text);
        QTest::keyClick(field, Qt::Key_V, Qt::ControlModifier);
    } else {
        for (const QChar character : text) {
            // Each key press may have closed or disabled the field.
            QWidget* focus = QApplication::focusWidget();
            if (!focus) return;
            QTest::sendKeyEvent(QTest::Click, focus, Qt::Key_unknown, QString(character), Qt::NoModifier);
        }
    }
    QWidget* focus = QApplication::focusWidget();
    if (focus && !oneIn(3)) QTest::keyClick(focus, Qt::Key_Return);
}

void Monkey::click(QWidget& window) {
    QWidget* popup = QApplication::activePopupWidget();
    QWidget* target = popup ? popup : anyWidget(window, isShown);
    if (!target) return;
    const QPoint at = target->mapTo(target->window(), anyPoint(*target));
    const QPointer<QWindow> handle = target->window()->windowHandle();
    if (!handle) return;
    const Qt::MouseButton button = anyButton();
    const Qt::KeyboardModifiers modifiers = anyModifiers();
    const bool twice = oneIn(6);
    note(QStringLiteral("%1 click %2 at %3,%4 of %5")
             .arg(twice ? QStringLiteral("double") : QStringLiteral("single"))
             .arg(int(button))
             .arg(at.x())
             .arg(at.y())
             .arg(nameOf(target)));
    // A press may close its window, above all a menu: then there is nothing to release.
    QTest::mousePress(handle, button, modifiers, at);
    if (handle) QTest::mouseRelease(handle, button, modifiers, at);
    if (twice && handle && handle->isVisible()) QTest::mouseDClick(handle, button, modifiers, at);
}

void Monkey::drag(QWidget& window) {
    QWidget* target = anyWidget(window, isShown);
    if (!target || QApplication::activePopupWidget()) return;
    const QPointer<QWindow> handle = target->window()->windowHandle();
    if (!handle) return;
    const Qt::MouseButton button = anyButton();
    const Qt::KeyboardModifiers modifiers = anyModifiers();
    QPoint at = target->mapTo(target->window(), anyPoint(*target));
    note(QStringLiteral("drag %1 from %2,%3 of %4")
             .arg(int(button))
             .arg(at.x())
             .arg(at.y())
             .arg(nameOf(target)));
    QTest::mousePress(handle, button, modifiers, at);
    const int moves = 1 + upTo(6);
    for (int i = 0; i < moves && handle; ++i) {
        at += QPoint(upTo(161) - 80, upTo(161) - 80);
        QTest::mouseMove(handle, at);
        if (oneIn(12) && QApplication::focusWidget())
            QTest::keyClick(QApplication::focusWidget(), any(keys), Qt::NoModifier);
    }
    if (handle) QTest::mouseRelease(handle, button, modifiers, at);
}

void Monkey::turnWheel(QWidget& window) {
    QWidget* target = anyWidget(window, isShown);
    if (!target) return;
    const QPoint at = anyPoint(*target);
    const Qt::KeyboardModifiers modifiers = anyModifiers();
    const int turns = 1 + upTo(8);
    const int direction = oneIn(2) ? 120 : -120;
    note(QStringLiteral("wheel %1 × %2 over %3").arg(turns).arg(direction).arg(nameOf(target)));
    const QPointer<QWidget> watched = target;
    for (int i = 0; i < turns && watched; ++i) {
        QWheelEvent event(at, target->mapToGlobal(QPointF(at)), {}, {0, direction}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        // As from the hand: only such events go on to the parent when the widget does not want them.
        QSpontaneKeyEvent::setSpontaneous(&event);
        qApp->notify(target, &event);
    }
}

void Monkey::choosePage(QWidget& window) {
    auto* pages = window.findChild<PageTabs*>();
    if (!pages || pages->count() == 0) return;
    const int page = upTo(pages->count());
    note(QStringLiteral("page %1").arg(page));
    if (pages->isOffered(page)) pages->setCurrentIndex(page);
}

void Monkey::triggerAction(QWidget& window) {
    QList<QAction*> actions;
    for (QAction* action : window.findChildren<QAction*>())
        if (action->isEnabled() && action->isVisible() && !action->isSeparator() && !action->menu())
            actions.append(action);
    if (actions.isEmpty()) return;
    QAction* action = any(actions);
    note(QStringLiteral("action %1").arg(action->text()));
    action->trigger();
}

void Monkey::undoOrRedo(QWidget& window) {
    const bool undo = !oneIn(3);
    const int times = 1 + upTo(5);
    note(QStringLiteral("%1 × %2").arg(undo ? QStringLiteral("undo") : QStringLiteral("redo")).arg(times));
    for (int i = 0; i < times; ++i)
        QTest::keyClick(&window, Qt::Key_Z,
                        undo ? Qt::ControlModifier : Qt::ControlModifier | Qt::ShiftModifier);
}

void Monkey::drop(QWidget& window) {
    QMimeData data;
    if (oneIn(8)) {
        data.setText(QStringLiteral("beta: 3"));
    } else {
        QList<QUrl> urls;
        const int count = oneIn(5) ? 2 : 1;
        for (int i = 0; i < count; ++i)
            urls.append(oneIn(10) ? QUrl(QStringLiteral("https://example.org/rod.yaml"))
                                  : QUrl::fromLocalFile(any(m_files.toOpen())));
        data.setUrls(urls);
    }
    note(QStringLiteral("drop %1").arg(data.text().simplified()));
    const QPoint at(upTo(window.width()), upTo(window.height()));
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    if (!enter.isAccepted()) return;
    QDropEvent dropped(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &dropped);
}

void Monkey::resize(QWidget& window) {
    static const QSize sizes[] = {{1000, 650}, {1440, 900},  {640, 400},
                                  {200, 200},  {1920, 1080}, {1100, 700}};
    const QSize size = any(sizes);
    note(QStringLiteral("resize to %1 × %2").arg(size.width()).arg(size.height()));
    window.resize(size);
}

void Monkey::changeColours(QWidget& /*window*/) {
    const bool dark = oneIn(2);
    note(dark ? QStringLiteral("dark palette") : QStringLiteral("light palette"));
    QApplication::setPalette(dark ? QPalette(QColor(0x35, 0x35, 0x35), QColor(0x23, 0x23, 0x23))
                                  : QPalette(QColor(0xef, 0xef, 0xef)));
}

void Monkey::changeFont(QWidget& /*window*/) {
    QFont font = QApplication::font();
    font.setPointSize(7 + upTo(10));
    note(QStringLiteral("font of %1 pt").arg(font.pointSize()));
    QApplication::setFont(font);
}

void Monkey::changeFiles(QWidget& /*window*/) {
    const int choice = upTo(20);
    note(QStringLiteral("change of files %1").arg(choice));
    m_files.change(choice);
}

void Monkey::loseActivation(QWidget& window) {
    note(QStringLiteral("activation lost and regained"));
    QEvent away(QEvent::WindowDeactivate);
    QApplication::sendEvent(&window, &away);
    window.hide();
    QCoreApplication::processEvents();
    window.show();
    window.activateWindow();
}

// Some menus of Qt run an event loop of their own. Nothing returns from there unless somebody acts inside.
void Monkey::watchNestedLoop(long act, int tries) {
    QTimer::singleShot(nestedWatchMs, this, [this, act, tries] {
        if (m_acts != act || !m_acting) return;
        watchNestedLoop(act, tries + 1);
        if (tries == nestedPatience) m_stuck = QStringLiteral("an event loop that does not end");
        // The first time, it may still be the act itself that handles its events.
        if (tries > 0) leaveNestedLoop();
    });
}

void Monkey::leaveNestedLoop() {
    if (QWidget* dialog = QApplication::activeModalWidget()) {
        m_stuck = QStringLiteral("a modal dialog: ") + nameOf(dialog);
        dialog->close();
        return;
    }
    QWidget* popup = QApplication::activePopupWidget();
    QWidget* target = popup ? popup : QApplication::focusWidget();
    if (!target) return;
    static const Qt::Key inMenus[] = {Qt::Key_Escape, Qt::Key_Escape, Qt::Key_Down,
                                      Qt::Key_Up,     Qt::Key_Return, Qt::Key_Right};
    QTest::keyClick(target, popup ? inMenus[m_nestedRandom.bounded(6)] : Qt::Key_Escape);
}

void Monkey::note(const QString& act) {
    const QString numbered = QStringLiteral("%1: %2").arg(m_acts).arg(act);
    m_record[static_cast<size_t>(m_acts) % m_record.size()] = numbered;
    if (m_talkative) qInfo("%s", qPrintable(numbered));
}

QStringList Monkey::record() const {
    QStringList acts;
    for (size_t i = 1; i <= m_record.size(); ++i) {
        const QString& act = m_record[(static_cast<size_t>(m_acts) + i) % m_record.size()];
        if (!act.isEmpty()) acts.append(act);
    }
    return acts;
}

QWidget* Monkey::anyWidget(QWidget& window, bool (*condition)(const QWidget*)) {
    QWidgetList widgets;
    for (QWidget* widget : window.findChildren<QWidget*>())
        if (condition(widget)) widgets.append(widget);
    return widgets.isEmpty() ? nullptr : any(widgets);
}

QPoint Monkey::anyPoint(const QWidget& widget) {
    return {upTo(std::max(1, widget.width())), upTo(std::max(1, widget.height()))};
}

Qt::KeyboardModifiers Monkey::anyModifiers() {
    static constexpr Qt::KeyboardModifier modifiers[] = {
        Qt::NoModifier,    Qt::NoModifier,      Qt::NoModifier,      Qt::NoModifier,
        Qt::ShiftModifier, Qt::ControlModifier, Qt::ControlModifier, Qt::AltModifier};
    return any(modifiers);
}

Qt::MouseButton Monkey::anyButton() {
    static constexpr Qt::MouseButton buttons[] = {Qt::LeftButton,   Qt::LeftButton,  Qt::LeftButton,
                                                  Qt::LeftButton,   Qt::RightButton, Qt::RightButton,
                                                  Qt::MiddleButton, Qt::BackButton};
    return any(buttons);
}

}  // namespace drillwave
