// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "widgets/common/filedialog.h"

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace nmc {

class ElidedLabel;
class MessageList;
class MessageModel;
class Requests;

/// The list of messages with its filter, and the file in which messages are kept beyond this session.
class MessagePanel : public QWidget {
    Q_OBJECT

public:
    /// `model` must outlive it.
    MessagePanel(const MessageModel& model, Requests& requests, QWidget* parent = nullptr);

    [[nodiscard]] MessageList& list() { return *m_list; }
    void reveal(const QString& key);
    /// Offers the modules of a chain of that many in the filter, under their present names.
    void offerModules(int count);
    /// `file`: where messages are kept; empty: they are not.
    void showLogFile(const QString& file);

private:
    void filter();
    void saveAs();

    Requests& m_requests;
    MessageList* m_list;
    QComboBox* m_kind = nullptr;
    QComboBox* m_module = nullptr;
    QLineEdit* m_text = nullptr;
    QCheckBox* m_notOver = nullptr;
    ElidedLabel* m_place = nullptr;
};

}  // namespace nmc
