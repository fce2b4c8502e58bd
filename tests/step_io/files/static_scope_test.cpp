#include "files/static_scope.h"

#include "suture/base/contract.h"

#include "step_io/files/assembly.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <iostream>

namespace suture::io::test {

namespace {

/// Counts what it is given.
class CountingPrinter : public Message_Printer {
  public:
    mutable int messages = 0;

  private:
    void send(const TCollection_AsciiString& /*text*/, Message_Gravity /*gravity*/) const override {
        ++messages;
    }
};

}  // namespace

TEST(StaticScope, TakesAwayAllPrintersAndBringsThemBack) {
    const auto printer = occ::make<CountingPrinter>();
    Message::DefaultMessenger()->AddPrinter(printer);
    {
        const StaticScope scope;
        Message::SendFail() << "unheard";
    }
    EXPECT_EQ(printer->messages, 0);
    Message::SendInfo() << "heard";
    EXPECT_EQ(printer->messages, 1);
    Message::DefaultMessenger()->RemovePrinter(printer);
}

TEST(StaticScope, RestoresParametersOfEachType) {
    { const StaticScope defines_the_parameters; }
    const std::string unit = Interface_Static::CVal("write.step.unit");
    const std::string product = Interface_Static::CVal("write.step.product.name");
    const int schema = Interface_Static::IVal("write.step.schema");
    const double precision = Interface_Static::RVal("write.precision.val");
    {
        StaticScope scope;
        scope.set("write.step.unit", "INCH");
        scope.set("write.step.schema", "AP203");
        scope.set("write.step.product.name", "gear");
        scope.set("write.precision.val", 0.5);
        EXPECT_STREQ(Interface_Static::CVal("write.step.unit"), "INCH");
        EXPECT_EQ(Interface_Static::RVal("write.precision.val"), 0.5);
    }
    EXPECT_EQ(Interface_Static::CVal("write.step.unit"), unit);
    EXPECT_EQ(Interface_Static::CVal("write.step.product.name"), product);
    EXPECT_EQ(Interface_Static::IVal("write.step.schema"), schema);
    EXPECT_EQ(Interface_Static::RVal("write.precision.val"), precision);
}

TEST(StaticScope, RefusesAParameterThatOcctDoesNotKnow) {
    StaticScope scope;
    EXPECT_THROW(scope.set("write.step.colour", 1), ContractViolation);
    EXPECT_THROW(scope.set("write.step.unit", "CUBIT"), ContractViolation);
}

TEST(StaticScope, SilencesOcctAndKeepsItsFirstComplaint) {
    ::testing::internal::CaptureStdout();
    {
        const StaticScope scope;
        Message::SendInfo() << "chatter";
        Message::SendFail() << "first";
        Message::SendFail() << "second";
        std::cout << "raw chatter\n";
        EXPECT_EQ(scope.complaint().substr(0, 5), "first");
    }
    std::cout << "after\n";
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "after\n");
}

TEST(StaticScope, LetsNothingThroughWhenFilesAreReadAndWritten) {
    const Folder folder;
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    for (const Format format : {Format::Step, Format::Iges}) {
        write(two_level_assembly(), folder / "a", format);
        read(folder / "a");
        std::string broken = content(folder / "a");
        broken[broken.size() / 2] = '(';
        save(folder / "b", broken);
        static_cast<void>(read_model(folder / "b", {}));
    }
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace suture::io::test
