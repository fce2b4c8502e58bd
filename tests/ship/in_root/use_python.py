"""What a Python user does first."""

import suture

print("suture", suture.version())
holes = suture.inspect("suitcase_corner.step")
result = suture.fill("suitcase_corner.step", "by_python.step", holes=[holes[0].id], page=True)
print(result.verdict)
assert result.good and result.closed and len(result.page) > 100_000
assert suture.check(result.shape).good
print("used: well")
