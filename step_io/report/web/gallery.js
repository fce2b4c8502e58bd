// The gallery of `suture demo`: a picture of every fill, shaded and with zebra stripes, all by one renderer.
import * as THREE from 'three';
import { ISO, distanceFor, towardsNewFaces } from './framing.js';
import { Scene } from './scene.js';
import { MODES, makeFaceGeometry, makeFaceMaterial } from './shading.js';

const WIDTH = 420;
const HEIGHT = 300;

/** All edges as pairs of points. */
function edgeGeometry({ edgePoints, edgeFirst }) {
  const positions = [];
  for (let edge = 1; edge < edgeFirst.length; ++edge) {
    for (let i = edgeFirst[edge - 1]; i + 1 < edgeFirst[edge]; ++i) positions.push(...edgePoints.subarray(3 * i, 3 * i + 6));
  }
  return new THREE.BufferGeometry().setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
}

class Painter {
  constructor() {
    this.canvas = document.createElement('canvas');
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setSize(WIDTH, HEIGHT, false);
    this.camera = new THREE.PerspectiveCamera(28, WIDTH / HEIGHT);
    this.camera.up.set(0, 0, 1);
    this.faces = makeFaceMaterial();
    this.edges = new THREE.LineBasicMaterial({ color: '#1c2024' });
    this.world = new THREE.Scene();
    this.world.background = new THREE.Color('#f3f5f7');
  }

  /** Draws a scene into the images, each as its data-shading says. */
  paint(scene, images) {
    const faces = makeFaceGeometry(scene.models[0], scene.newFaces);
    const edges = edgeGeometry(scene.models[0]);
    faces.computeBoundingSphere();
    const { center, radius } = faces.boundingSphere;
    const direction = towardsNewFaces(scene) ?? new THREE.Vector3(...ISO);
    const distance = distanceFor(this.camera, radius);
    this.camera.position.copy(center).addScaledVector(direction.normalize(), distance);
    this.camera.near = distance / 500;
    this.camera.far = distance + 4 * radius;
    this.camera.lookAt(center);
    this.camera.updateProjectionMatrix();
    this.world.clear();
    this.world.add(new THREE.Mesh(faces, this.faces), new THREE.LineSegments(edges, this.edges));
    for (const image of images) {
      const { shading } = image.dataset;
      this.faces.uniforms.mode.value = MODES.indexOf(shading);
      this.faces.uniforms.freshShown.value = shading === 'shaded' ? 1 : 0;
      this.renderer.render(this.world, this.camera);
      image.setAttribute('src', this.canvas.toDataURL());
    }
    faces.dispose();
    edges.dispose();
  }

  dispose() {
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}

/** One after the other, so that the page can be read meanwhile. */
export async function showGallery(gallery) {
  try {
    const painter = new Painter();
    for (const figure of gallery.querySelectorAll('figure')) {
      const { textContent } = document.getElementById(`scene:${figure.dataset.scene}`);
      painter.paint(new Scene(JSON.parse(textContent)), figure.querySelectorAll('img'));
      await new Promise((done) => { setTimeout(done); });
    }
    painter.dispose();
  } catch (error) {
    gallery.prepend(Object.assign(document.createElement('p'), { textContent: `This browser shows no 3D (${error.message}).` }));
  }
  document.documentElement.dataset.ready = Math.round(performance.now());
}
