// SPDX-License-Identifier: GPL-3.0-or-later
// A row of controls that continues in further lines if the window is narrow.
#pragma once

#include <QLayout>
#include <memory>
#include <vector>

namespace drillwave {

/// Layout that places items side by side at their preferred sizes, in as many lines as necessary. An item
/// wider than a line gets its own line, in which its contents may wrap.
class FlowLayout : public QLayout {
    Q_OBJECT

  public:
    explicit FlowLayout(QWidget* parent = nullptr);
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override;
    int count() const override { return static_cast<int>(m_items.size()); }
    QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    Qt::Orientations expandingDirections() const override { return {}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return arrange({0, 0, width, 0}, Moving::no); }
    QSize minimumSize() const override;
    /// Returns the size that the items need in a single line.
    QSize sizeHint() const override;
    void setGeometry(const QRect& area) override;

  private:
    enum class Moving { no, yes };
    int arrange(const QRect& area, Moving moving) const;
    QSize sizeIn(const QLayoutItem& item, int width) const;

    std::vector<std::unique_ptr<QLayoutItem>> m_items;
};

}  // namespace drillwave
