#include "files/static_scope.h"

#include "suture/base/contract.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <iostream>

namespace suture::io {

namespace {

/// Keeps the first complaint, drops everything else.
class FirstComplaint : public Message_Printer {
  public:
    explicit FirstComplaint(std::shared_ptr<std::string> text) : text_(std::move(text)) {}

  private:
    void send(const TCollection_AsciiString& message, Message_Gravity gravity) const override {
        if (gravity >= Message_Fail && text_->empty()) {
            *text_ = message.ToCString();
        }
    }
    std::shared_ptr<std::string> text_;
};

/// OCCT's globals are process-wide, and so is this lock.
std::mutex& occt_globals() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace

StaticScope::StaticScope()
    : lock_(occt_globals()),
      auto_naming_(XCAFDoc_ShapeTool::AutoNaming()),
      complaint_(std::make_shared<std::string>()) {
    std::cout.flush();
    cout_buffer_ = std::cout.rdbuf(&silence_);
    Message_SequenceOfPrinters& printers = Message::DefaultMessenger()->ChangePrinters();
    printers_ = printers;
    printers.Clear();
    printers.Append(occ::make<FirstComplaint>(complaint_));
    XCAFDoc_ShapeTool::SetAutoNaming(false);  // no parts called "SOLID"
    STEPCAFControl_Controller::Init();        // the parameters exist only after this
}

StaticScope::~StaticScope() {
    for (auto saved = saved_.rbegin(); saved != saved_.rend(); ++saved) {
        const char* name = saved->parameter->Name();
        if (const int* integer = std::get_if<int>(&saved->value)) {
            Interface_Static::SetIVal(name, *integer);
        } else if (const double* real = std::get_if<double>(&saved->value)) {
            Interface_Static::SetRVal(name, *real);
        } else {
            Interface_Static::SetCVal(name, std::get<std::string>(saved->value).c_str());
        }
    }
    XCAFDoc_ShapeTool::SetAutoNaming(auto_naming_);
    Message::DefaultMessenger()->ChangePrinters() = printers_;
    std::cout.rdbuf(cout_buffer_);
}

void StaticScope::save(const char* name) {
    const occ::Handle<Interface_Static> parameter = Interface_Static::Static(name);
    SUTURE_EXPECTS(!parameter.IsNull());
    switch (parameter->Type()) {
        case Interface_ParamInteger:
        case Interface_ParamEnum:
            saved_.push_back({parameter, parameter->IntegerValue()});
            break;
        case Interface_ParamReal:
            saved_.push_back({parameter, parameter->RealValue()});
            break;
        default:
            saved_.push_back({parameter, std::string(parameter->CStringValue())});
    }
}

void StaticScope::set(const char* name, int value) {
    save(name);
    SUTURE_EXPECTS(Interface_Static::SetIVal(name, value));
}

void StaticScope::set(const char* name, double value) {
    save(name);
    SUTURE_EXPECTS(Interface_Static::SetRVal(name, value));
}

void StaticScope::set(const char* name, const char* value) {
    save(name);
    SUTURE_EXPECTS(Interface_Static::SetCVal(name, value));
}

}  // namespace suture::io
