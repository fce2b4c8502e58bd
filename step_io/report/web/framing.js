// Where to look from.
import * as THREE from 'three';

/** From the model to the eye, z upwards. */
export const ISO = [1, -1.2, 0.8];

/** The direction from which the new faces are seen; none without any. */
export function towardsNewFaces(scene) {
  const sum = new THREE.Vector3();
  const { first, corners, normals } = scene.models[0] ?? {};
  for (const face of scene.newFaces) {
    for (let i = 3 * first[face - 1]; i < 3 * first[face]; ++i) {
      sum.add(new THREE.Vector3().fromArray(normals, 3 * corners[i]));
    }
  }
  return sum.length() < 1e-6 ? null : sum.normalize().addScaledVector(new THREE.Vector3(...ISO).normalize(), 0.25);
}

/** How far off the camera sees all of a ball. */
export function distanceFor(camera, radius) {
  const half = (camera.fov * Math.PI) / 360;
  return radius / Math.sin(Math.atan(Math.tan(half) * Math.min(camera.aspect, 1)));
}
