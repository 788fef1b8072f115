// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window/layout_check.h"

#include <qcustomplot.h>
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <algorithm>

#include "tests/support/contrast.h"

namespace drillwave {
namespace {

QString describe(const QWidget& widget, const QString& text = {}) {
    return QStringLiteral("%1 “%2” %3 %4×%5")
        .arg(QLatin1String(widget.metaObject()->className()), widget.objectName(), text)
        .arg(widget.width())
        .arg(widget.height());
}

template <typename Kind>
QList<const Kind*> shownOf(const QWidget& window) {
    QList<const Kind*> shown;
    for (const Kind* each : window.findChildren<Kind*>())
        if (each->isVisible()) shown.append(each);
    return shown;
}

// Panels scroll up and down; what is cut off at their side cannot be reached.
bool sticksOut(const QWidget& widget) {
    for (const QWidget* above = widget.parentWidget(); above && !widget.isWindow();
         above = above->parentWidget()) {
        const auto* area = qobject_cast<const QScrollArea*>(above);
        if (!area) continue;
        const int left = widget.mapTo(area->viewport(), QPoint()).x();
        return left < 0 || left + widget.width() > area->viewport()->width();
    }
    return false;
}

bool fits(const QLabel& label) {
    if (label.text().isEmpty()) return true;
    if (label.wordWrap()) return label.height() >= label.heightForWidth(label.width());
    const QSize wanted = label.sizeHint();
    return label.width() >= wanted.width() && label.height() >= label.fontMetrics().height();
}

bool fits(const QAbstractButton& button) {
    const QSize text = button.fontMetrics().size(Qt::TextShowMnemonic, button.text());
    return button.width() >= text.width() && (button.text().isEmpty() || button.height() >= text.height());
}

// Titles and names of files may be longer than their field and scroll; numbers may not.
bool fits(const QAbstractSpinBox& box) {
    const auto* edit = box.findChild<QLineEdit*>();
    const int room = edit->contentsRect().width() - 2;
    return box.fontMetrics().horizontalAdvance(edit->text()) <= room;
}

template <typename Kind>
void appendClipped(const QWidget& window, QStringList& found) {
    for (const Kind* each : shownOf<Kind>(window))
        if (!fits(*each) || sticksOut(*each))
            found.append(describe(*each, each->property("text").toString()));
}

QColor behind(const QWidget& widget) {
    const QWidget* painter = &widget;
    while (!painter->autoFillBackground() && !painter->isWindow()) painter = painter->parentWidget();
    return painter->palette().color(painter->backgroundRole());
}

bool isControl(const QWidget& widget) {
    if (widget.focusPolicy() == Qt::NoFocus || !widget.isVisible()) return false;
    if (qobject_cast<const QScrollBar*>(&widget)) return false;
    if (qobject_cast<const QAbstractSpinBox*>(widget.parentWidget())) return false;  // its line edit
    return qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QLineEdit*>(&widget) ||
           qobject_cast<const QAbstractSpinBox*>(&widget) || qobject_cast<const QAbstractSlider*>(&widget) ||
           qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QAbstractItemView*>(&widget) ||
           qobject_cast<const QCustomPlot*>(&widget);
}

QString spokenName(QWidget& widget) {
    const QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(&widget);
    return accessible ? accessible->text(QAccessible::Name) : widget.accessibleName();
}

}  // namespace

QStringList clippedTexts(const QWidget& window) {
    QStringList found;
    appendClipped<QLabel>(window, found);
    appendClipped<QAbstractButton>(window, found);
    appendClipped<QAbstractSpinBox>(window, found);
    return found;
}

QStringList cutTabs(const QWidget& window) {
    QStringList found;
    for (const QTabBar* bar : shownOf<QTabBar>(window))
        for (int tab = 0; tab < bar->count(); ++tab) {
            const int words = bar->fontMetrics().horizontalAdvance(bar->tabText(tab));
            // Tabs that are scrolled out of sight are whole all the same; captions give way.
            if (bar->isTabEnabled(tab) && bar->tabRect(tab).width() < words)
                found.append(QStringLiteral("tab “%1” is cut").arg(bar->tabText(tab)));
        }
    return found;
}

QStringList flatPlots(const QWidget& window) {
    constexpr int leastLines = 2, leastLinesOfOne = 3;
    QStringList found;
    for (const QCustomPlot* plot : shownOf<QCustomPlot>(window)) {
        const int line = plot->fontMetrics().height();
        int highest = 0;
        for (const QCPAxisRect* rect : plot->axisRects()) {
            if (!rect->realVisibility()) continue;
            highest = std::max(highest, rect->height());
            if (rect->height() < leastLines * line)
                found.append(describe(*plot, QStringLiteral("axes %1 high").arg(rect->height())));
        }
        if (highest < leastLinesOfOne * line)
            found.append(describe(*plot, QStringLiteral("no axes higher than %1").arg(highest)));
    }
    return found;
}

QStringList overlaps(const QWidget& window) {
    QStringList found;
    for (const QLayout* layout : window.findChildren<QLayout*>()) {
        QList<const QWidget*> members;
        for (int i = 0; i < layout->count(); ++i)
            if (const QWidget* widget = layout->itemAt(i)->widget(); widget && widget->isVisible())
                members.append(widget);
        for (int i = 0; i < members.size(); ++i)
            for (int j = 0; j < i; ++j)
                if (members[i]->parentWidget() == members[j]->parentWidget() && !members[i]->isWindow() &&
                    members[i]->geometry().intersects(members[j]->geometry()))
                    found.append(describe(*members[i]) + QStringLiteral(" over ") + describe(*members[j]));
    }
    return found;
}

QStringList namelessControls(const QWidget& window) {
    QStringList found;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        if (!isControl(*widget)) continue;
        if (spokenName(*widget).isEmpty())
            found.append(describe(*widget) + QStringLiteral(" without a name"));
    }
    return found;
}

QStringList faintTexts(const QWidget& window) {
    QStringList found;
    const auto look = [&found](const QWidget& widget, const QString& text) {
        if (text.isEmpty() || !widget.isEnabled()) return;
        const double ratio = test::contrast(widget.palette().color(widget.foregroundRole()), behind(widget));
        if (ratio < test::leastContrast)
            found.append(QStringLiteral("%1 of %2").arg(ratio).arg(describe(widget, text)));
    };
    for (const QLabel* label : shownOf<QLabel>(window)) look(*label, label->text());
    for (const QAbstractButton* button : shownOf<QAbstractButton>(window)) look(*button, button->text());
    return found;
}

}  // namespace drillwave
