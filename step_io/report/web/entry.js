// Which page it is: that of one model, or a gallery of many, each of which opens as a page of its own.
import { showGallery } from './gallery.js';

const gallery = document.getElementById('gallery');
const chosen = gallery && document.getElementById(`scene:${decodeURIComponent(location.hash.slice(1))}`);
if (gallery) window.addEventListener('hashchange', () => location.reload());
if (gallery && !chosen) showGallery(gallery);
else {
  if (chosen) {
    chosen.id = 'suture-scene';
    for (const other of document.querySelectorAll('script.suture-scene')) if (other !== chosen) other.remove();
    const line = document.createElement('p');
    line.append(Object.assign(document.createElement('a'), { href: '#', textContent: '← All examples' }), ` ${chosen.dataset.title}`);
    gallery.replaceWith(line);
  }
  import('./main.js');
}
