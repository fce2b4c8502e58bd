#pragma once

#include "suture/base/contract.h"
#include "suture/base/result.h"

#include <Standard_Failure.hxx>
#include <TopoDS_Shape.hxx>

#include <exception>
#include <new>
#include <string_view>
#include <type_traits>
#include <utility>

namespace suture::occ {

namespace detail {

template <class T>
struct IsResult : std::false_type {};
template <class T>
struct IsResult<Result<T>> : std::true_type {};

}  // namespace detail

/// Runs `action`, the only place where OCCT's exceptions are caught: Standard_Failure, which is no
/// std::exception in OCCT 7.6, becomes an Error (Internal) that begins with `what`. A null shape is
/// an error as well: OCCT can return one with IsDone() true.
///
/// Input    action returns a value, nothing, or a Result.
template <class Action>
[[nodiscard]] auto guarded(std::string_view what, Action&& action) {
    using Value = std::invoke_result_t<Action>;
    using Out = std::conditional_t<detail::IsResult<Value>::value, Value, Result<Value>>;
    try {
        if constexpr (std::is_void_v<Value>) {
            std::forward<Action>(action)();
            return Out();
        } else {
            Out result(std::forward<Action>(action)());
            if constexpr (std::is_base_of_v<TopoDS_Shape, Value>) {
                if (result->IsNull()) {
                    return Out(fail(ErrorCode::Internal, "{}: OCCT returned no shape", what));
                }
            }
            return result;
        }
    } catch (const Standard_Failure& failure) {
        const char* text = failure.GetMessageString();
        return Out(fail(ErrorCode::Internal, "{}: OCCT raised {}{}{}", what,
                        failure.DynamicType()->Name(), text && *text ? ": " : "",
                        text ? text : ""));
    } catch (const ContractViolation&) {
        throw;  // a bug of ours is not an answer
    } catch (const std::bad_alloc&) {
        return Out(fail(ErrorCode::Internal, "{}: out of memory", what));
    } catch (const std::exception& error) {
        return Out(fail(ErrorCode::Internal, "{}: {}", what, error.what()));
    }
}

}  // namespace suture::occ
