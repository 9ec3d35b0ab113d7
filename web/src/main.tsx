// SPDX-License-Identifier: Apache-2.0
import {render} from 'preact';

import {startPool} from './engine/start';
import {embedded} from './store/embedded';
import {type Entry, arrive, placeOf} from './store/address';
import {addressChanged, followLessons, goToPlace, resume} from './store/learning';
import {fetchLater} from './store/later';
import {keepPage} from './store/memory';
import {followMissing} from './store/opening';
import {followOwnPicture} from './store/own';
import {followOwnLog} from './store/own_log';
import {openFirst} from './store/scene';
import {failure, services, state} from './store/state';
import {App} from './ui/App';
import {Embed} from './ui/Embed';
import {connectViews} from './ui/pictures';

render(embedded ? <Embed /> : <App />, document.getElementById('app')!);
try {
    const pool = services.pool = await startPool();
    connectViews(pool);
    const isOpen = await openFirst(), place = placeOf(location.hash);
    if (place) await arrive(() => (isOpen ? resume(place) : goToPlace(place)));
    if (!embedded) {
        keepPage();
        followLessons();
        followOwnPicture();
        followOwnLog();
        followMissing();
        fetchLater(() => pool.fetchWhole());
    }
} catch (error) {
    failure.value = `The engine could not be started: ${error instanceof Error ? error.message : String(error)}`;
    state.value = 'error';
}
addEventListener('popstate', ({state: entry}) => void addressChanged(entry as Entry | null));
// It fetches all files of the page. Without it, the page needs its server the next time it is opened.
if (import.meta.env.PROD && 'serviceWorker' in navigator) fetchLater(() => navigator.serviceWorker.register('./sw.js'));
