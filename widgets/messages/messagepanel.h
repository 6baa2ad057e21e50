// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <set>

#include "widgets/common/filedialog.h"
#include "widgets/messages/messagelines.h"

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace nmc {

class ElidedLabel;
class MessageList;

/// The list of messages, what of it is shown, and where it is kept beyond this session.
class MessagePanel : public QWidget {
    Q_OBJECT

public:
    explicit MessagePanel(QWidget* parent = nullptr);

    [[nodiscard]] MessageList& list() { return *m_list; }
    /// All entries, whatever is shown.
    void showMessage(const Message& message);
    void reveal(const QString& key);
    /// `file`: what is told is kept there; empty: it is not.
    void showLogFile(const QString& file);

signals:
    /// What is shown, as text; the user has agreed that the file is replaced.
    void saveRequested(const QString& path, const nmc::FileContent& content);

private:
    void build();
    void filter();
    void offerModule(const Message& message);
    void saveAs();

    QComboBox* m_kind = nullptr;
    QComboBox* m_module = nullptr;
    QLineEdit* m_text = nullptr;
    QCheckBox* m_notOver = nullptr;
    MessageList* m_list = nullptr;
    ElidedLabel* m_place = nullptr;
    std::set<ModuleIndex> m_modules;  ///< that some message was about
};

}  // namespace nmc
