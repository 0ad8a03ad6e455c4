var Nt,Lm,Ny,lr,df,nc,Dm,Kl,Nm,mf,pf,Oy,Na=Symbol.for("pv"),ic={},sc=[],Fy=/^m(i|n|o|s|text|space)$/,gf=Array.isArray,Om=sc.slice,Or=Object.assign;function Nr(n){n&&n.parentNode&&n.remove()}function Ql(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Na,__v:s||++Lm,__i:-1,__u:0};return!s&&Nt.vnode&&Nt.vnode(r),r}function Ot(n){return n.children}function ec(n,e){this.props=n,this.context=e,this.__g=0}function cr(n,e){if(e==null)return n.__&&cr(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:cr(n)}function Uy(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Or({constructor:Na},t)).__v=t.__v+1,Nt.vnode&&Nt.vnode(e),_f(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||cr(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,Vm(s,e,r),t.__=t.__e=null,e.__e!=i&&Fm(e))}function Fm(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),Fm(n)}function Pm(n){(8&n.__g||(n.__g|=8,lr.push(n),nc++))&&df==Nt.debounceRendering||((df=Nt.debounceRendering)||queueMicrotask)(Um)}function Um(){try{for(var n,e=1;lr.length;)lr.length>e&&lr.sort(Dm),n=lr.shift(),e=lr.length,8&n.__g&&Uy(n)}finally{(nc=lr.length)&&(df||queueMicrotask)(Um)}}function Bm(n,e,t,i,s,r,o,a,l,c,u){var h,f,d,x,y,p,m=i.__k||sc,_=e.length;for(l=By(t,e,m,l,_),h=0;h<_;h++)(d=t.__k[h])!=null&&(f=~d.__i&&m[d.__i]||ic,d.__i=h,p=_f(n,d,f,s,r,o,a,l,c,u),x=d.__e,(f.ref!=d.ref||8&f.__u)&&(f.ref&&xf(f.ref,null,d,f),d.ref&&u.push(d.ref,d.__c||x,d)),y=y||x,4&d.__u?(l=km(d,l,n,!f.__v),f.__e&&(f.__e=null)):typeof d.type=="function"&&p!==void 0?l=p:x&&(l=x.nextSibling),d.__u&=-21);return t.__e=y,l}function By(n,e,t,i,s){var r,o,a,l,c,u,h,f,d,x=t.length,y=x,p=0,m=0,_=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=_[r]=Ql(null,o):gf(o)?o=_[r]=Ql(Ot,{children:o}):o.constructor===Na&&o.__b?o=_[r]=Ql(o.type,o.props,o.key,o.ref,o.__v):_[r]=o,l=r+p,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=ky(o,t,l,y))&&(y--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?p--:c==l+1?p++:c!=l&&(c>l?p--:p++,m=1)):(~c||(s>x?p--:s<x&&p++),typeof o.type!="function"&&(o.__u|=4))):_[r]=null;if(m){for(u=[],h=[],r=0;r<s;r++)if((o=_[r])&&16&o.__u){for(p=0,f=u.length;p<f;)u[d=p+f>>1]<o.__i?p=d+1:f=d;u[p]=o.__i,h[r]=p+1}for(p=u.length;r--;)h[r]&&(h[r]==p?p--:_[r].__u|=4)}if(y)for(r=0;r<x;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=cr(a)),vf(a,a));return i}function km(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=km(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=cr(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function ky(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Im(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Zl(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Im(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Im(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=pf[e]||(pf[e]=zy(e)),(n.__a||(n.__a={}))[e]=mf,r=e!=(e=e.replace(Nm,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function zy(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[Kl]==null)e[Kl]=mf++;else if(e[Kl]<this.__a[n])return;return t(Nt.event?Nt.event(e):e)}}}function _f(n,e,t,i,s,r,o,a,l,c){var u,h,f,d,x,y,p,m,_,S,b,M,w,g,T,L,P,D,I=e.type;if(e.constructor!==Na)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,h=r=[],u.nodeType==8?a=tc(u,r):r.push(u),a=r[0]||a),(u=Nt.__b)&&u(e);e:if(typeof I=="function"){f=o.length;try{if(m=e.props,_=(u=I.prototype)&&u.render,S=(u=I.contextType)&&i[u.__c],b=u?S?S.props.value:u.__:i,(d=t.__c)?(e.__c=d,2&d.__g&&(d.__g|=1)):(_?e.__c=d=new I(m,b):(e.__c=d=new ec(m,b),d.constructor=I,d.render=Gy),S&&S.sub(d),d.state||(d.state={}),d.__n=i,d.__g|=8,d.__h=[],d.__k=[]),_&&(d.__s||(d.__s=d.state),I.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=Or({},d.__s)),Or(d.__s,I.getDerivedStateFromProps(m,d.__s)))),x=d.props,y=d.state,d.__v=e,t.__c){if(m!==x&&_&&!I.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(m,b),e.__v==t.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(m,d.__s,b)===!1){e.__v!=t.__v&&(d.props=m,d.state=d.__s,d.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(U){U&&(U.__=e)}),sc.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=cr(t);break e}d.componentWillUpdate&&d.componentWillUpdate(m,d.__s,b),_&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(x,y,p)})}else _&&!I.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),_&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=b,d.props=m,d.__P=n,d.__g&=-5,M=Nt.__r,w=_?25:0;do d.__g&=-9,M&&M(e),u=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++w<25);_&&(sc.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(i=Or({},i,d.getChildContext())),_&&t.__c&&d.getSnapshotBeforeUpdate&&(p=d.getSnapshotBeforeUpdate(x,y)),g=u&&u.type===Ot&&u.key==null?u.props.children:u,m.__P&&(u=a,s=(n=m.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(U){U&&vf(U,U)}),t.__k=null),a=t.__k?cr(t,0):null),a=Bm(n,gf(g)?g:[g],e,t,i,s,r,o,a,l,c),m.__P&&(e.__e=null,a=u),e.__u&=-161,h&&h.some(Nr),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(U){if(o.length=f,e.__v=null,l||r)if(U&&U.then){if(e.__u|=128|l,r){for(~(P=r.indexOf(a||void 0))||(P=r.length);(D=r[P-1])&&D.nodeType==8;)P--;for(;P<r.length;P++)if(D=r[P])if(r[P]=null,T){if(D==L)break}else{if(D.nodeType!=8)break;D.data.startsWith("$s")&&(L=tc(T=D))}}if(!T){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;T=a}(u=tc(T=e.__c.__z||(e.__c.__z=T)))?(e.__e=T,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(Nr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),U&&U.then||zm(e),Nt.__e(U,e,t)}}else a=e.__e=Vy(t.__e,e,t,i,s,r,o,l,c,n);return(u=Nt.diffed)&&u(e),a}function tc(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function zm(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(zm))}function Vm(n,e,t){for(var i=0;i<t.length;)xf(t[i++],t[i++],t[i++]);Nt.__c&&Nt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Nt.__e(r,s.__v)}})}function Vy(n,e,t,i,s,r,o,a,l,c){var u,h,f,d,x,y,p,m,_=t.props||ic,S=e.props,b=e.type;if(b=="svg"?s="http://www.w3.org/2000/svg":b=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((x=r[u])&&(b?x.localName==b:x.nodeType==3)){n=x,r[u]=null;break}}if(!n){if(m=c.ownerDocument||document,!b)return m.createTextNode(S);n=m.createElementNS(s,b,S.is?S:c),a&&(Nt.__m&&Nt.__m(e,r),a=!1),r=null}if(b){if(c=b=="template"&&n.content||n,r=b=="textarea"&&S.defaultValue!=null?null:r&&Om.call(c.childNodes),!a&&r)for(_={},u=0;u<n.attributes.length;u++)_[(x=n.attributes[u]).name]=x.value;for(u in _)x=_[u],u=="dangerouslySetInnerHTML"?f=x:u=="children"||u in S||u=="value"&&"defaultValue"in S||u=="checked"&&"defaultChecked"in S||Zl(n,u,null,x,s);for(u in S)x=S[u],u=="children"?d=x:u=="dangerouslySetInnerHTML"?h=x:u=="value"?y=x:u=="checked"?p=x:a&&typeof x!="function"||_[u]===x||Zl(n,u,x,_[u],s);h?(a||f&&(h.__html==f.__html||h.__html==n.innerHTML)||(n.innerHTML=h.__html),e.__k=[]):(f&&(n.textContent=""),(b=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Fy.test(b))&&(s="http://www.w3.org/1999/xhtml"),Bm(c,gf(d)?d:[d],e,t,i,s,r,o,r?r[0]:t.__k&&cr(t,0),a,l),r&&r.some(Nr)),a&&b!="textarea"||(u="value",b=="progress"&&y==null?n.removeAttribute(u):y==null||y===n[u]&&(b!="progress"||y)||Zl(n,u,y,_[u],s),u="checked",p!=null&&p!=n[u]&&Zl(n,u,p,_[u],s))}else _===S||a&&n.data==S||(n.data=S);return n}function xf(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Nt.__e(s,t)}}function vf(n,e,t){var i,s,r,o;if(Nt.unmount&&Nt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||xf(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Nt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&vf(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=tc(i,r=[]))&&(i==n.__e&&r.some(Nr),Nr(s),Nr(i)),t||Nr(n.__e),n.__e=n.__c=n.__=null}function Gy(n,e,t){return this.constructor(n,t)}function Gm(n,e){var t,i,s,r;Nt.__&&Nt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Ql(Ot,{children:[n]}),s=[],r=[],_f(e,e.__k,i||ic,ic,e.namespaceURI,i?null:e.firstChild?Om.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),Vm(s,e.__k,r),e.__k.props.children=null}Nt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw nc=0,n}},Lm=0,Ny=function(n){return n!=null&&n.constructor===Na},ec.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Or({},this.state)),typeof n=="function"&&(n=n(Or({},t),this.props)),n&&(Or(t,n),this.__v&&(e&&this.__k.push(e),Pm(this)))},ec.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Pm(this))},ec.prototype.render=Ot,lr=[],nc=0,Dm=function(n,e){return n.__v.__b-e.__v.__b},Kl=Symbol(),Nm=/(PointerCapture)$|Capture$/i,mf=0,pf={},Oy=0;var To,vn,yf,Hm,bf=Object.is,rc=0,Km=[],Sf=[],fn=Nt,Wm=fn.__b,Xm=fn.__r,qm=fn.diffed,$m=fn.__c,Ym=fn.unmount,Jm=fn.__;function oc(n,e){fn.__h&&fn.__h(vn,n,rc||e),rc=0;var t=vn.__H||(vn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function pe(n){return rc=1,Hy(eg,n)}function Hy(n,e,t){var i=oc(To++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):eg(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);bf(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=vn,!vn.__f)){vn.__f=!0;var s=vn.shouldComponentUpdate;vn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(f){f.__N&&(c=!0,bf(f.__[0],f.__N[0])||(u=!0))}),s){var h=s.call(this,r,o,a);return c?h||u:h}return!c||u}}return i.__}function xt(n,e){var t=oc(To++,3);!fn.__s&&wf(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,vn.__H.__h.push(t))}function Qm(n,e){var t=oc(To++,4);!fn.__s&&wf(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,vn.__h.push(t))}function tn(n){return rc=5,ii(function(){return{current:n}},[])}function ii(n,e){var t=oc(To++,7);return wf(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function Wy(){var n;do{for(;n=Sf.shift();)try{Oa(n)}catch(t){fn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=Km.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Oa),e.__h.some(Mf),e.__h=[]}catch(t){e.__h=[],fn.__e(t,n.__v)}}}while(Sf.length)}fn.__b=function(n){vn=null,Wm&&Wm(n)},fn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Jm&&Jm(n,e)},fn.__r=function(n){Xm&&Xm(n),To=0;var e=(vn=n.__c).__H;e&&(yf==vn?vn.__h=[]:(e.__h.some(Oa),e.__h.some(Mf),To=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),yf=vn},fn.diffed=function(n){qm&&qm(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&Zm(Km.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),yf=vn=null},fn.__c=function(n,e){e.some(function(t){try{t.__h.some(Oa),t.__h=t.__h.filter(function(i){return!i.__||Mf(i)})}catch(i){t.__h=[function(){throw i}]}}),$m&&$m(n,e)},fn.unmount=function(n){Ym&&Ym(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,Zm(Sf.push(s))}else Oa(s)}catch(r){e=r}}),i.__H=void 0,e&&fn.__e(e,i.__v))};var jm=typeof requestAnimationFrame=="function";function Xy(n){var e,t=function(){clearTimeout(i),jm&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);jm&&(e=requestAnimationFrame(t))}function Zm(n){n!=1&&Hm==fn.requestAnimationFrame||((Hm=fn.requestAnimationFrame)||Xy)(Wy)}function Oa(n){var e=vn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),vn=e}function Mf(n){var e=vn;n.__c=n.__(),vn=e}function wf(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!bf(t,n[i])})}function eg(n,e){return typeof e=="function"?e(n):e}var lc=["queued","running","succeeded","failed","cancelled","expired","dead"],Fa=n=>n.phase==="displacement"&&n.energy!==void 0,hi=class extends Error{constructor(t){super(t.detail??t.title);this.problem=t}problem},Tf="homolog-key",ac=[],Fr={get:()=>sessionStorage.getItem(Tf),set(n){n===null?sessionStorage.removeItem(Tf):sessionStorage.setItem(Tf,n)}};function tg(n){return ac.push(n),()=>{ac=ac.filter(e=>e!==n)}}var cc=n=>new URL(n,document.baseURI.split("#")[0]);async function si(n,e={}){let t=new Headers(e.headers),i=Fr.get();i!==null&&t.set("authorization",`Bearer ${i}`);let s=await fetch(cc(n),{...e,headers:t,cache:e.cache??"no-cache"});if(s.status===401&&ac.forEach(o=>o()),s.ok||s.status===304)return s;let r={type:"about:blank",title:s.statusText,status:s.status};try{r=await s.json()}catch{}throw new hi(r)}async function Mt(n,e){return(await si(n,{signal:e})).json()}async function ri(n,e,t){let i={method:n};return t!==void 0&&(i.body=JSON.stringify(t),i.headers={"content-type":"application/json"}),(await si(e,i)).json()}async function Af(n,e){let t=e?window.open("","_blank"):null;t&&(t.opener=null);try{let{ticket:i}=Fr.get()===null?{ticket:null}:await ri("POST","v1/tickets",{path:`/${n}`}),s=cc(`${n}${yi({ticket:i})}`).href;t?t.location.href=s:location.assign(s)}catch(i){throw t?.close(),i}}async function uc(n,e){Ua(await(await si(n)).blob(),e)}function Ua(n,e){let t=document.createElement("a");t.href=URL.createObjectURL(n),t.download=e,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function yi(n){let e=Object.entries(n).filter(([,i])=>i!=null&&i!==""),t=new URLSearchParams(e.map(([i,s])=>[i,String(s)])).toString();return t===""?"":`?${t}`}var Jt=n=>{if(n instanceof hi){let e=n.problem.errors?.map(t=>`${t.pointer}: ${t.detail}`).join("; ");return[n.problem.title,n.problem.detail,e].filter(Boolean).join(": ")}return n instanceof TypeError?"The service cannot be reached.":String(n)};function Re(n,e=3){return n==null||!Number.isFinite(n)?"–":Number.isInteger(n)?n.toLocaleString("en"):n.toLocaleString("en",{maximumSignificantDigits:e})}var bi=n=>n==null?"–":`${n.toFixed(2)} mm`,Ao=n=>`${(100*n).toFixed(n>.995||n<.1?1:0)} %`;function Di(n){if(n<1e3)return`${Math.round(n)} ms`;let e=n/1e3;return e<60?`${e.toFixed(1)} s`:e<3600?`${Math.floor(e/60)} min ${Math.round(e%60)} s`:e<86400?`${Math.floor(e/3600)} h ${Math.round(e%3600/60)} min`:`${Math.floor(e/86400)} d ${Math.round(e%86400/3600)} h`}var ds=(n,e)=>{let t=e-Date.parse(n);return t<1e3?"now":Di(Math.floor(t/1e3)*1e3).replace(".0 s"," s")},hc=n=>n<1024?`${n} B`:n<1<<20?`${(n/1024).toFixed(1)} KiB`:`${(n/(1<<20)).toFixed(1)} MiB`,jt=n=>n.replaceAll("_"," "),oi=n=>n!=="queued"&&n!=="running",ai=n=>n.slice(-8),qy={unlike_shape:{meaning:"Corresponding points differ in curvature or direction, or one surface is much longer than the other.",check:"Do both files show the same structure? Is a part of one missing?"},other_handedness:{meaning:"A mirrored source fits better.",check:"Is one file a left structure and the other a right one, or does an image have a flipped axis?"},uncertain_side:{meaning:"A file states two orientations of different handedness: left and right may be exchanged.",check:"Which orientation of the file is right? Write it into both places (sform and qform)."},units_differ:{meaning:"The sizes differ by the ratio of two units of length.",check:"Are both files in millimetres? Scale one of them, or state its unit in the file."},ambiguous_pose:{meaning:"A different pose fits as well.",check:"Is the shape nearly symmetric? Landmarks resolve it: submit again with a few corresponding points."},piece_dropped:{meaning:"A structure is in several pieces, and one that was dropped has 5 % or more of its volume.",check:"Are left and right one label, or several structures? Choose the labels of one, or name the repair largest_component."},labels_joined:{meaning:"Several labels of one input were joined, and the other input has other labels.",check:"Which labels are the structure? Submit again with them."},cavity_filled:{meaning:"A structure had cavities of 5 % or more of its volume, or closing them and its tunnels changed as much.",check:"Is the label a wall around something else? Name the repair fill to confirm that the inside belongs to it."},second_opinion:{meaning:"The default method finds another pose for these surfaces, or other corresponding points.",check:"Which of the two answers is right? Submit again with the method balanced, and look at both."},too_coarse:{meaning:"The voxels are so large for the structure that they leave its rotation uncertain.",check:"Is there a segmentation of smaller voxels? Interpolating this one adds nothing."}};function ng(n){if(n.state==="succeeded"){if(n.reliable===!0)return{tone:"good",mark:"✓",title:"Reliable",lines:[`No check found a fault. ${n.surface_distance?`The registered surfaces are ${bi(n.surface_distance.mean_mm)} apart on average.`:""}`,...n.warnings??[]],next:"Look for colors that jump in the picture below; if there are none, keep this match."};if(n.reliable===!1){let i=(n.unreliable_reasons??[]).map(s=>qy[s]??{meaning:jt(s),check:""});return{tone:"bad",mark:"✕",title:"Not reliable",lines:[...i.map(s=>s.meaning),...n.warnings??[]],next:i.map(s=>s.check).join(" ")}}return{tone:"neutral",mark:"?",title:"Not checked",lines:["This method fits no displacement field, which the checks are made of.",...n.warnings??[]],next:"Judge by the picture, or match again with the method balanced."}}let t={queued:{tone:"wait",mark:"…",title:"Waiting",lines:[n.queue_position?`Number ${n.queue_position} in the queue.`:"In the queue."],next:"It starts when a worker is free."},running:{tone:"wait",mark:"…",title:n.cancel_requested?"Being cancelled":"Running",lines:[n.eta_ms?`About ${Di(n.eta_ms)} left.`:"The verdict comes with the result."],next:"The energy below shows how the match improves; each round begins anew."},cancelled:{tone:"neutral",mark:"–",title:"Cancelled",lines:["It has no result."],next:"Submit it again with Retry."},expired:{tone:"bad",mark:"✕",title:"Expired",lines:["It had not started by its deadline."],next:"Submit it again with Retry, or with a later deadline."}}[n.state];return t||{tone:"bad",mark:"✕",title:n.state==="dead"?"Given up":"Failed",lines:[[n.error?.title,n.error?.detail].filter(Boolean).join(": ")||"It has no result."],next:n.state==="dead"?"Its workers crashed too often. Retry once; if it fails again, report it.":"Correct the input, then submit it again."}}function fc(n){if(n.state!=="succeeded")return{tone:"neutral",text:""};if(n.reliable===!0)return{tone:"good",text:"✓ reliable"};let[e,...t]=n.unreliable_reasons??[];return n.reliable===!1?{tone:"bad",text:`✕ ${jt(e??"not reliable")}${t.length>0?` and ${t.length} more`:""}`}:{tone:"neutral",text:"not checked"}}function ig(n){return typeof n=="object"?n.key:n}function sg(n,e){let t=n.length;return new Proxy(n,{get(i,s,r){if(typeof s=="string"){let o=s.charCodeAt(0);if(o>=48&&o<=57){let a=+s;if(Number.isInteger(a)&&a>=0&&a<t){let l=i[a];if(typeof l!="object"){let c=e[a*2];l=i[a]={index:a,key:l,start:c,size:e[a*2+1],end:c+e[a*2+1],lane:0}}return l}}if(s==="length")return t}return Reflect.get(i,s,r)}})}function Ur(n,e,t){let i=t.initialDeps??[],s,r=!0;function o(){var a;let c=0,u=n();if(!(u.length!==i.length||u.some((d,x)=>i[x]!==d)))return s;i=u;let f=0;return s=e(...u),t?.onChange&&!(r&&t.skipInitialOnChange)&&t.onChange(s),r=!1,s}return o.updateDeps=a=>{i=a},o}function Ef(n,e){if(n===void 0)throw new Error(`Unexpected undefined${e?`: ${e}`:""}`);return n}var Is=(n,e)=>Math.abs(n-e)<1.01,rg=(n,e,t)=>{let i;return Object.assign(function(...s){n.clearTimeout(i),i=n.setTimeout(()=>e.apply(this,s),t)},{cancel:()=>{n.clearTimeout(i)}})};function og({offset:n,isScrolling:e,elementMax:t,holdOffset:i,scrollOffset:s,pendingWrite:r,clampedMaxAtWrite:o}){var a;return e&&r===null&&n===s?"spurious":r!==null&&Math.abs(n-r.target)<1.5?"readBack":r!==null&&!r.smooth&&t!==null&&r.target>t+i+.5&&Math.abs(n-(t+i))<1.5||r!==null&&!r.smooth&&((a=r.lowMaxes)!=null&&a.some(l=>Math.abs(n-l)<1.5))?"clampedReadBack":o!==null&&Math.abs(n-o)<1.5?"clampedEcho":"external"}var $y=n=>n==="smooth"||n==="smoothFinishing";function ag({kind:n,offset:e,command:t,target:i}){return n!=="spurious"&&n!=="readBack"&&n!=="clampedReadBack"&&t?.index!=null&&t.phase!=="queued"&&!$y(t.phase)&&!Is(e,t.lastTargetOffset)&&!Is(e,i())&&n!=="clampedEcho"}var Cf=40;function lg(n){let e=n[n.length-1];if(e===void 0)return!1;let t=n.length-2;for(;t>=0&&e.t-n[t].t<Cf;)t--;if(t<0)return!1;let i=n[t],s=t-1;for(;s>=0&&i.t-n[s].t<Cf;)s--;if(s<0)return!1;let r=n[s],o=(e.offset-i.offset)/(e.t-i.t),a=(i.offset-r.offset)/(i.t-r.t);return o*a>=0&&Math.abs(o)>=2*Math.abs(a)&&Math.abs(o)-Math.abs(a)>=.8}function cg(n){let e=n[n.length-1];if(e===void 0)return!1;let t=n.length-2;for(;t>=0&&e.t-n[t].t<Cf;)t--;if(t<0)return!1;let i=n[t];return Math.abs(e.offset-i.offset)/(e.t-i.t)>=.05}var Ba,ka=()=>{if(Ba!==void 0)return Ba;if(typeof navigator>"u")return Ba=!1;if(/iP(hone|od|ad)/.test(navigator.userAgent))return Ba=!0;let n=navigator.maxTouchPoints;return Ba=navigator.platform==="MacIntel"&&n!==void 0&&n>0},Rf,Yy=()=>Rf!==void 0?Rf:Rf=ka()&&typeof CSS<"u"&&typeof CSS.supports=="function"&&CSS.supports("overflow-anchor: auto"),ug=()=>!ka()||Yy();var Eo={capture:!0,passive:!0},dc=class{constructor(e){this.host=e,this._touch=null,this.inMotion=()=>this._touch!==null&&this._touch.phase!=="lateFling",this.dragging=()=>{var t;return((t=this._touch)==null?void 0:t.phase)==="down"&&this._touch.moved},this.tail=()=>{var t;return((t=this._touch)==null?void 0:t.phase)==="tail"?this._touch.moved?"fling":"tap":null},this.onScroll=({isScrolling:t,ownReadBack:i,moved:s,external:r})=>{var o,a,l;return t&&((o=this._touch)==null?void 0:o.phase)==="tail"?this._openTail(this._touch.moved||!i,!1):((a=this._touch)==null?void 0:a.phase)==="lateFling"&&(this.host.now()>this._touch.until?this._touch=null:r&&t&&s&&this._openTail(!0,!1)),!i&&t&&s&&((l=this._touch)==null?void 0:l.phase)==="down"?(this._touch.moved=!0,!0):!1},this.touchStart=()=>{this.end(),this._touch={phase:"down",moved:!1}},this.touchEnd=()=>{var t;let i=((t=this._touch)==null?void 0:t.phase)==="down"&&this._touch.moved;this.end(),this._openTail(i,i)},this.end=()=>{var t;let i=this.host.getWindow();((t=this._touch)==null?void 0:t.phase)==="tail"&&i!=null&&i.clearTimeout(this._touch.timerId),this._touch=null},this.listen=t=>{let i=()=>this.touchStart(),s=()=>this.touchEnd();return t.addEventListener("touchstart",i,Eo),t.addEventListener("touchend",s,Eo),t.addEventListener("touchcancel",s,Eo),()=>{t.removeEventListener("touchstart",i,Eo),t.removeEventListener("touchend",s,Eo),t.removeEventListener("touchcancel",s,Eo),this.end()}},this._openTail=(t,i)=>{let s=this.host.getWindow();if(s==null)return;this.end();let r={phase:"tail",moved:t,awaitingFling:i,timerId:s.setTimeout(()=>{if(this.host.tailStillMoving()){this._openTail(r.moved,r.awaitingFling);return}this._touch=r.awaitingFling?{phase:"lateFling",until:this.host.now()+1e3}:null,this.host.onTailClosed()},150)};this._touch=r}}get touch(){return this._touch}};var hg=n=>{let{clientWidth:e,clientHeight:t}=n;return{width:e,height:t}},pg=n=>{let e=new Set;return{schedule:t=>{let i=n.requestAnimationFrame(()=>{e.delete(i),t()});e.add(i)},cancel:()=>{e.forEach(t=>n.cancelAnimationFrame(t)),e.clear()}}},Jy=n=>n,jy=n=>{let e=n.overscan*Math.max(n.lanes??1,1),t=Math.max(n.startIndex-e,0),s=Math.min(n.endIndex+e,n.count-1)-t+1,r=new Array(s);for(let o=0;o<s;o++)r[o]=t+o;return r},mg=(n,e)=>{let t=n.scrollElement;if(!t)return;let i=n.targetWindow;if(!i)return;let s=a=>{let{width:l,height:c}=a;e({width:Math.round(l),height:Math.round(c)})};if(s(hg(t)),!i.ResizeObserver)return()=>{};let r=pg(i),o=new i.ResizeObserver(()=>{let a=()=>{s(hg(t))};n.options.useAnimationFrameWithResizeObserver?r.schedule(a):a()});return o.observe(t,{box:"content-box"}),()=>{o.unobserve(t),r.cancel()}},fg={passive:!0};var Zy=typeof window>"u"?!0:"onscrollend"in window,Ky=(n,e,t)=>{let i=n.scrollElement;if(!i)return;let s=n.targetWindow;if(!s)return;let r=n.options.useScrollendEvent&&Zy,o=0,a=r?null:rg(s,()=>e(t(i),!1),n.options.isScrollingResetDelay),l=h=>()=>{o=t(i),a?.(),e(o,h)},c=l(!0),u=l(!1);return i.addEventListener("scroll",c,fg),r&&i.addEventListener("scrollend",u,fg),()=>{i.removeEventListener("scroll",c),r&&i.removeEventListener("scrollend",u),a?.cancel()}},gg=(n,e)=>Ky(n,e,t=>{let{horizontal:i,isRtl:s}=n.options;return i?t.scrollLeft*(s&&-1||1):t.scrollTop});var Qy=(n,e,t)=>{if(t.options.useCachedMeasurements){let i=t.indexFromElement(n),s=t.options.getItemKey(i);return t.itemSizeCache.get(s)??t.options.estimateSize(i)}if(e?.borderBoxSize){let i=e.borderBoxSize[0];if(i)return Math.round(i[t.options.horizontal?"inlineSize":"blockSize"])}if(!e){let i=t.indexFromElement(n),s=t.options.getItemKey(i),r=t.itemSizeCache.get(s);if(r!==void 0)return r}return n[t.options.horizontal?"offsetWidth":"offsetHeight"]},eb=(n,{adjustments:e=0,behavior:t},i)=>{var s;let{scrollElement:r,options:o}=i,a=n+e,l=o.horizontal&&o.isRtl&&r!==null&&"ownerDocument"in r;(s=r?.scrollTo)==null||s.call(r,{[o.horizontal?"left":"top"]:l?-a:a,behavior:t})};var _g=eb,dg=(n,e)=>n==="smooth"?e?"smoothLanded":"smooth":"instant",za=n=>n?.phase==="smooth"||n?.phase==="smoothLanded";function tb(n,e,t,i){if(e===0)return!1;let s=i(0),r=new Set,o=0;for(;o<n;){let l=t(o);if(l===s)break;r.add(l),o++}let a=n-o;if(a===0||a>=e)return!1;for(let l=0;l<a;l++)if(i(l)!==t(o+l))return!1;for(let l=a;l<e;l++)if(r.has(i(l)))return!1;return!0}var pc=class{constructor(e){this.unsubs=[],this.scrollElement=null,this.targetWindow=null,this.isScrolling=!1,this.scrollState=null,this.measurementsCache=[],this._singleLaneMeasurements=null,this.itemSizeCache=new Map,this.itemSizeCacheVersion=0,this.laneAssignments=new Map,this.pendingMin=null,this.prevLanes=void 0,this.lanesChangedFlag=!1,this.lanesSettling=!1,this.pendingScrollAnchor=null,this.scrollRect=null,this.scrollOffset=null,this.scrollDirection=null,this._holdOffset=0,this._reportedOverscroll=!1,this._iosGesture=new dc({getWindow:()=>this.targetWindow,now:()=>this.now(),tailStillMoving:()=>{let t=this.scrollState;if(t?.phase!=="queued"||this.pendingWrite!==null)return!1;let i=this._readElementOffset();return i===null||this._lastElementOffset===null||Math.abs(i-this._lastElementOffset)<1?!1:(this._lastElementOffset=i,t.samples=[...t.samples??[],{t:this.now(),offset:i}],!0)},onTailClosed:()=>{let t=this.scrollState;t?.phase==="queued"&&cg(t.samples??[])&&(this.scrollState=null),this._flushHoldIfReady(!0),this._writeAwaitingCommand(),this._retryClampedAdjustment()}}),this._lastElementOffset=null,this.pendingWrite=null,this._clampedAdjustment=null,this.elementsCache=new Map,this._resizeBatch=null,this.now=()=>{var t,i,s;return((s=(i=(t=this.targetWindow)==null?void 0:t.performance)==null?void 0:i.now)==null?void 0:s.call(i))??Date.now()},this.observer=(()=>{let t=null,i=null,s=!1,r=!1,o=new Set,a=()=>{if(t)return t;let c=this.targetWindow;if(!c||!c.ResizeObserver)return null;let u=i=pg(c);return t=new c.ResizeObserver(h=>{let f=()=>{let d={sync:!1};this._resizeBatch=d;try{h.forEach(l)}finally{this._resizeBatch=null,d.notify&&(this.notify(d.sync),this._noteClampMax(),this._flushHoldIfReady(!0),this._retryClampedAdjustment(),this.measureElement(null))}};if(this.options.useAnimationFrameWithResizeObserver)u.schedule(f);else{s=!0;try{f()}finally{s=!1}}})},l=c=>{let u=c.target,h=this.indexFromElement(u);if(!u.isConnected){this.observer.unobserve(u);for(let[f,d]of this.elementsCache)if(d===u){this.elementsCache.delete(f);break}return}this.isIndexInRange(h)&&this.shouldMeasureDuringScroll(h)&&this.resizeItem(h,this.options.measureElement(u,c,this))};return{disconnect:()=>{var c;(c=a())==null||c.disconnect(),i?.cancel(),o.clear(),r=!1,t=null,i=null},observe:c=>{let u=a();if(u){if(!s){u.observe(c,{box:"border-box"});return}o.add(c),r||(r=!0,i?.schedule(()=>{r=!1,o.forEach(h=>{h.isConnected&&t?.observe(h,{box:"border-box"})}),o.clear()}))}},unobserve:c=>{var u;o.delete(c),(u=a())==null||u.unobserve(c)}}})(),this.range=null,this.setOptions=t=>{var i;let s={debug:!1,initialOffset:0,overscan:1,paddingStart:0,paddingEnd:0,scrollPaddingStart:0,scrollPaddingEnd:0,horizontal:!1,getItemKey:Jy,rangeExtractor:jy,onChange:()=>{},measureElement:Qy,initialRect:{width:0,height:0},scrollMargin:0,gap:0,indexAttribute:"data-index",initialMeasurementsCache:[],lanes:1,anchorTo:"start",followOnAppend:!1,scrollEndThreshold:1,isScrollingResetDelay:150,enabled:!0,isRtl:!1,useScrollendEvent:!1,useAnimationFrameWithResizeObserver:!1,laneAssignmentMode:"estimate",useCachedMeasurements:!1};for(let u in t){let h=t[u];h!==void 0&&(s[u]=h)}let r=this.options,o=null,a=null,l=!1;if(r!==void 0&&r.enabled&&s.enabled&&s.anchorTo==="end"&&this.scrollElement!==null){let u=r.count,h=s.count,f=this.getMeasurements(),d=((i=this._singleLaneMeasurements)==null?void 0:i.items)??f,x=S=>ig(d[S]),y=u>0?x(0):null,p=u>0?x(u-1):null;if(h!==u||u>0&&h>0&&(s.getItemKey(0)!==y||s.getItemKey(h-1)!==p)){l=!0;let S=u>0?this.getVirtualItemForOffset(this.getScrollOffset())??f[0]:null;S&&(o=[S.key,this.getScrollOffset()-S.start]);let b=s.followOnAppend===!0?"auto":s.followOnAppend||null;b&&h>0&&this.isAtEnd(r.scrollEndThreshold)&&(u===0||s.getItemKey(h-1)!==p)&&(h>u||tb(u,h,x,s.getItemKey))&&(a=b)}}this.options=s,l&&(this.pendingMin=0,this.itemSizeCacheVersion++);let c=null;if(o&&this.scrollOffset!==null&&!this._awaitingCommandReadBack()){let[u,h]=o,f=this.getMeasurements(),{count:d,getItemKey:x}=this.options,y=0;for(;y<d&&x(y)!==u;)y++;if(y<d){let p=f[y];if(p){let m=Math.max(0,p.start+h);!a&&m!==this.scrollOffset&&(c=m-this.scrollOffset,this.scrollOffset=m)}}}a?this.pendingScrollAnchor={kind:"follow",behavior:a}:c!==null&&(this._canWriteScroll()?this.pendingScrollAnchor={kind:"anchor",delta:c}:(this._holdOffset+=c,this._followOffsetTarget(c)))},this.notify=t=>{var i,s;(s=(i=this.options).onChange)==null||s.call(i,this,t)},this.maybeNotify=Ur(()=>(this.calculateRange(),[this.isScrolling,this.range?this.range.startIndex:null,this.range?this.range.endIndex:null]),t=>{this.notify(t)},{key:!1,debug:()=>this.options.debug,initialDeps:[this.isScrolling,this.range?this.range.startIndex:null,this.range?this.range.endIndex:null]}),this.cleanup=()=>{var t;this.unsubs.filter(Boolean).forEach(i=>i()),this.unsubs=[],this.observer.disconnect(),this.rafId!=null&&this.targetWindow&&(this.targetWindow.cancelAnimationFrame(this.rafId),this.rafId=null),this.scrollState=null,(t=this._momentumStop)==null||t.restore(),this._momentumStop=null,this.isScrolling=!1,this.scrollDirection=null,this._holdOffset=0,this._reportedOverscroll=!1,this._clampedAdjustment=null,this.pendingWrite=null,this.scrollElement=null,this.targetWindow=null},this._didMount=()=>()=>{this.cleanup()},this._willUpdate=()=>{var t;let i=this.options.enabled?this.options.getScrollElement():null;if(this.scrollElement!==i){if(this.cleanup(),!i){this.maybeNotify();return}this.scrollElement=i,this.scrollElement&&"ownerDocument"in this.scrollElement?this.targetWindow=this.scrollElement.ownerDocument.defaultView:this.targetWindow=((t=this.scrollElement)==null?void 0:t.window)??null,this.elementsCache.forEach(r=>{this.observer.observe(r)}),this.unsubs.push(this.options.observeElementRect(this,r=>{this.scrollRect=r,this.maybeNotify()})),this.unsubs.push(this.options.observeElementOffset(this,(r,o)=>{var a,l,c,u;let h=o?this._elementMaxScrollOffset():null,f=this._reportedOverscroll;this._reportedOverscroll=r<0||h!==null&&r>h+1;let d=r;this._lastElementOffset=d,r=this._toLayoutOffset(r);let x=this._classifyScrollEvent(r,o,h);if(x==="spurious")return;x==="readBack"?r=this.pendingWrite.target:x==="clampedReadBack"&&((a=this.scrollState)==null?void 0:a.index)!=null&&r<this.getMaxScrollOffset()-1.5?this.scrollState.lastTargetOffset=r:ag({kind:x,offset:r,command:this.scrollState,target:()=>this.getScrollStateTarget(this.scrollState)})&&(this.scrollState=null),this.pendingWrite=null,this._clampedAdjustment!==null&&Math.abs(r-this._clampedAdjustment.maxAtWrite)>=1.5&&(this._clampedAdjustment=null);let y=this.getScrollOffset(),p=this.scrollDirection;this.scrollDirection=o?y===r?this.scrollDirection:y<r?"forward":"backward":null,this.scrollOffset=r,this.isScrolling=o;let m=this.scrollState;if(m?.phase==="queued"&&x==="external"&&o)if(f||this._reportedOverscroll)m.samples=[];else{let _=this.now();m.samples=[...(m.samples??[]).filter(S=>_-S.t<=200),{t:_,offset:d}],(p!==null&&this.scrollDirection!==p||lg(m.samples))&&(this.scrollState=null)}this._iosGesture.onScroll({isScrolling:o,ownReadBack:x==="readBack",moved:r!==y,external:x==="external"&&((l=this.scrollState)==null?void 0:l.phase)!=="smooth"&&((c=this.scrollState)==null?void 0:c.phase)!=="smoothFinishing"})&&((u=this.scrollState)==null?void 0:u.phase)==="queued"&&(this.scrollState=null),this._flushHoldIfReady(!0),this.scrollState&&this.scheduleScrollReconcile(),this.maybeNotify()})),"addEventListener"in this.scrollElement&&this.unsubs.push(this._iosGesture.listen(this.scrollElement)),this._scrollToOffset(this.getScrollOffset())}this._noteClampMax();let s=this.pendingScrollAnchor;this.pendingScrollAnchor=null,s&&this.scrollElement&&this.options.enabled&&(s.kind==="anchor"?this._canWriteScroll()?za(this.scrollState)&&!Is(this.getScrollOffset()-s.delta,this.scrollState.lastTargetOffset)||(this._followOffsetTarget(s.delta),this._scrollToOffset(this.getScrollOffset())):(this._holdOffset+=s.delta,this._followOffsetTarget(s.delta),this.notify(!1)):this.scrollToEnd({behavior:s.behavior})),this._flushHoldIfReady(!1),this._retryClampedAdjustment()},this._classifyScrollEvent=(t,i,s)=>{var r;return og({offset:t,isScrolling:i,elementMax:s,holdOffset:this._holdOffset,scrollOffset:this.scrollOffset,pendingWrite:this.pendingWrite,clampedMaxAtWrite:((r=this._clampedAdjustment)==null?void 0:r.maxAtWrite)??null})},this._retryClampedAdjustment=()=>{if(this._clampedAdjustment===null||!this.scrollElement||!this.options.enabled||!this._canWriteScroll())return;let{target:t,maxAtWrite:i}=this._clampedAdjustment,s=this.getMaxScrollOffset();s>i+.5&&(this._clampedAdjustment=t>s+.5?{target:t,maxAtWrite:s}:null,this._scrollToOffset(t))},this._writeAwaitingCommand=()=>{let t=this.scrollState;if(t===null||t.phase!=="queued")return;let{behavior:i}=t;this.getMeasurements();let s=this.getScrollStateTarget(t);t.lastTargetOffset=s,this._clampedAdjustment=null,t.phase=dg(i,t.index!=null&&Is(s,this.getScrollOffset())),this._scrollToOffset(s,{behavior:i}),this.scheduleScrollReconcile()},this._readElementOffset=()=>{let t=this.scrollElement;if(t==null)return null;let{horizontal:i,isRtl:s}=this.options;return typeof t.scrollTop=="number"?i?t.scrollLeft*(s&&-1||1):t.scrollTop:typeof t.scrollY=="number"?i?t.scrollX:t.scrollY:null},this._canWriteScroll=()=>!(ka()&&this._iosGesture.inMotion())&&!this._reportedOverscroll,this._flushHoldIfReady=t=>{var i;if(this._holdOffset===0||!this.scrollElement||!this.options.enabled||!this._canWriteScroll()||((i=this.scrollState)==null?void 0:i.phase)==="smooth")return;this._holdOffset=0,this.scrollOffset!==null&&this.scrollOffset<0&&(this.scrollOffset=0),this.notify(t);let s=this.getCommandWrittenOffset()??this.getScrollOffset();this._clampedAdjustment=this._clampedBy(s),this._scrollToOffset(s)},this.rafId=null,this.getSize=()=>this.options.enabled?(this.scrollRect=this.scrollRect??this.options.initialRect,this.scrollRect[this.options.horizontal?"width":"height"]):(this.scrollRect=null,0),this.getScrollOffset=()=>this.options.enabled?(this.scrollOffset=this.scrollOffset??(typeof this.options.initialOffset=="function"?this.options.initialOffset():this.options.initialOffset),this.scrollOffset):(this.scrollOffset=null,0),this.getMeasurementOptions=Ur(()=>[this.options.count,this.options.paddingStart,this.options.scrollMargin,this.options.getItemKey,this.options.enabled,this.options.lanes,this.options.laneAssignmentMode,this.options.gap],(t,i,s,r,o,a,l,c)=>(this.prevLanes!==void 0&&this.prevLanes!==a&&(this.lanesChangedFlag=!0),this.prevLanes=a,this.pendingMin=null,{count:t,paddingStart:i,scrollMargin:s,getItemKey:r,enabled:o,lanes:a,laneAssignmentMode:l,gap:c}),{key:!1}),this.isIndexInRange=t=>t>=0&&t<this.options.count,this.getMeasurements=Ur(()=>[this.getMeasurementOptions(),this.itemSizeCacheVersion],({count:t,paddingStart:i,scrollMargin:s,getItemKey:r,enabled:o,lanes:a,laneAssignmentMode:l,gap:c},u)=>{var h;let f=this.itemSizeCache;if(!o)return this.measurementsCache=[],this._singleLaneMeasurements=null,this.itemSizeCache.clear(),this.laneAssignments.clear(),[];if(this.laneAssignments.size>t)for(let _ of this.laneAssignments.keys())_>=t&&this.laneAssignments.delete(_);this.lanesChangedFlag&&(this.lanesChangedFlag=!1,this.lanesSettling=!0,this.measurementsCache=[],this._singleLaneMeasurements=null,this.itemSizeCache.clear(),this.laneAssignments.clear(),this.pendingMin=null),this.measurementsCache.length===0&&!this.lanesSettling&&(this.measurementsCache=this.options.initialMeasurementsCache,this.measurementsCache.forEach(_=>{this.itemSizeCache.set(_.key,_.size)}));let d=this.lanesSettling?0:this.pendingMin??0;if(this.pendingMin=null,this.lanesSettling&&this.measurementsCache.length===t&&(this.lanesSettling=!1),a===1){let _=t*2,S=(h=this._singleLaneMeasurements)==null?void 0:h.flat;if(!S||S.length<_){let g=new Float64Array(_);S&&d>0&&g.set(S.subarray(0,d*2)),S=g}let b=d===0?new Array(t):this._singleLaneMeasurements.items.slice(),M;if(d===0)M=i+s;else{let g=d-1;M=S[g*2]+S[g*2+1]+c}for(let g=d;g<t;g++){let T=r(g);b[g]=T;let L=f.get(T),P=typeof L=="number"?L:this.options.estimateSize(g);S[g*2]=M,S[g*2+1]=P,M+=P+c}this._singleLaneMeasurements={flat:S,items:b};let w=sg(b,S);return this.measurementsCache=w,w}let x=this.measurementsCache.slice(0,d),y=new Array(a).fill(void 0),p=new Float64Array(a),m=0;for(let _=0;_<d;_++){let S=x[_];S&&(y[S.lane]===void 0&&m++,y[S.lane]=_,p[S.lane]=S.end)}for(let _=d;_<t;_++){let S=r(_),b=this.laneAssignments.get(_),M,w,g=l==="estimate"||f.has(S);if(b!==void 0&&this.options.lanes>1){M=b;let D=y[M],I=D!==void 0?x[D]:void 0;w=I?I.end+c:i+s}else if(m===a){let D=0,I=p[0],U=y[0];for(let N=1;N<a;N++){let G=p[N];(G<I||G===I&&y[N]<U)&&(D=N,I=G,U=y[N])}M=D,w=I+c,g&&this.laneAssignments.set(_,M)}else M=_%this.options.lanes,w=i+s,g&&this.laneAssignments.set(_,M);let T=f.get(S),L=typeof T=="number"?T:this.options.estimateSize(_),P=w+L;x[_]={index:_,start:w,size:L,end:P,key:S,lane:M},y[M]===void 0&&m++,y[M]=_,p[M]=P}return this.measurementsCache=x,x},{key:!1,debug:()=>this.options.debug}),this.calculateRange=Ur(()=>[this.getMeasurements(),this.getSize(),this.getScrollOffset(),this.options.lanes,this._getLayoutTotalSize()+this.options.scrollMargin],(t,i,s,r,o)=>{if(t.length===0||i===0)return this.range=null,null;let a=Math.max(o-i,0);return this.range=ib(t,i,Math.min(s,a),r,r===1&&this._singleLaneMeasurements!==null?this._singleLaneMeasurements.flat:null),this.range},{key:!1,debug:()=>this.options.debug}),this.getVirtualIndexes=Ur(()=>{let t=null,i=null,s=this.calculateRange();return s&&(t=s.startIndex,i=s.endIndex),this.maybeNotify.updateDeps([this.isScrolling,t,i]),[this.options.rangeExtractor,this.options.overscan,this.options.count,t,i,this.options.lanes]},(t,i,s,r,o,a)=>r===null||o===null?[]:t({startIndex:r,endIndex:o,overscan:i,count:s,lanes:a}),{key:!1,debug:()=>this.options.debug}),this.indexFromElement=t=>{let i=this.options.indexAttribute,s=t.getAttribute(i);return s?parseInt(s,10):(console.warn(`Missing attribute name '${i}={index}' on measured element.`),-1)},this.shouldMeasureDuringScroll=t=>{var i;if(!za(this.scrollState))return!0;let s=this.scrollState.index??((i=this.getVirtualItemForOffset(this.scrollState.lastTargetOffset))==null?void 0:i.index);if(s!==void 0&&this.range){let r=Math.max(this.options.overscan,Math.ceil((this.range.endIndex-this.range.startIndex)/2)),o=Math.max(0,s-r),a=Math.min(this.options.count-1,s+r);return t>=o&&t<=a}return!0},this.measureElement=t=>{if(!t){this.elementsCache.forEach((o,a)=>{o.isConnected||(this.observer.unobserve(o),this.elementsCache.delete(a))});return}let i=this.indexFromElement(t);if(!this.isIndexInRange(i))return;let s=this.options.getItemKey(i),r=this.elementsCache.get(s);r!==t&&(r&&this.observer.unobserve(r),this.observer.observe(t),this.elementsCache.set(s,t)),t.isConnected&&(!this.isScrolling||this.scrollState)&&this.shouldMeasureDuringScroll(i)&&this.resizeItem(i,this.options.measureElement(t,void 0,this))},this.resizeItem=(t,i)=>{var s,r,o;if(!this.isIndexInRange(t))return;(s=this._resizeBatch)!=null&&s.sync&&this.getMeasurements();let a,l,c,u=(r=this._singleLaneMeasurements)==null?void 0:r.flat;if(this.options.lanes===1&&u!=null)c=this.options.getItemKey(t),l=u[t*2],a=u[t*2+1];else{let d=this.measurementsCache[t];if(!d)return;c=d.key,l=d.start,a=d.size}let h=this.itemSizeCache.get(c)??a,f=i-h;if(f!==0){let d=this.options.anchorTo==="end"&&!za(this.scrollState)&&this.getVirtualDistanceFromEnd()<=this.options.scrollEndThreshold,x=d?this._getLayoutTotalSize():0,y=this.getScrollOffset(),m=!this.itemSizeCache.has(c)?l<y:l+h<=y&&this.scrollDirection!=="backward",_=!za(this.scrollState)&&(this.shouldAdjustScrollPositionOnItemSizeChange!==void 0?this.shouldAdjustScrollPositionOnItemSizeChange(this.measurementsCache[t]??{index:t,key:c,start:l,size:a,end:l+a,lane:0},f,this):m);(this.pendingMin===null||t<this.pendingMin)&&(this.pendingMin=t),this.itemSizeCache.set(c,i),this.itemSizeCacheVersion++;let S=!1;if(this._awaitingCommandReadBack()||(d?S=this.applyScrollAdjustment(this._getLayoutTotalSize()-x):_&&(S=this.applyScrollAdjustment(f))),this._resizeBatch){this._resizeBatch.notify=!0,(o=this._resizeBatch).sync||(o.sync=S);return}this.notify(S),this._noteClampMax(),this._flushHoldIfReady(!0),this._retryClampedAdjustment()}},this.getVirtualItems=Ur(()=>[this.getVirtualIndexes(),this.getMeasurements(),this._holdOffset],(t,i,s)=>{let r=[];for(let o=0,a=t.length;o<a;o++){let l=t[o],c=i[l];r.push(s===0?c:{...c,start:c.start-s,end:c.end-s})}return r},{key:!1,debug:()=>this.options.debug}),this.getVirtualItemForOffset=t=>{var i;let s=this.getMeasurements();if(s.length===0)return;let r=(i=this._singleLaneMeasurements)==null?void 0:i.flat,o=this.options.lanes===1&&r!=null,a=xg(0,s.length-1,o?l=>r[l*2]:l=>Ef(s[l]).start,t);return Ef(s[a])},this._noteClampMax=()=>{if(!this._awaitingCommandReadBack())return;let t=this._elementMaxScrollOffset();if(t===null)return;let i=this.pendingWrite,s=Math.max(t,0)+this._holdOffset;if(s>=i.target)return;let r=i.lowMaxes??(i.lowMaxes=[]);r[r.length-1]!==s&&r.push(s)},this.getMaxScrollOffset=()=>(this._elementMaxScrollOffset()??0)+this._holdOffset,this._toLayoutOffset=t=>{var i;let s=t+this._holdOffset;return((i=this.pendingScrollAnchor)==null?void 0:i.kind)==="anchor"&&(s+=this.pendingScrollAnchor.delta),s},this._elementMaxScrollOffset=()=>{let t=this.scrollElement;if(t===null)return null;if("scrollHeight"in t)return this.options.horizontal?t.scrollWidth-t.clientWidth:t.scrollHeight-t.clientHeight;if("document"in t){let i=t.document.documentElement;return this.options.horizontal?i.scrollWidth-t.innerWidth:i.scrollHeight-t.innerHeight}return null},this._momentumStop=null,this._stopMomentum=t=>{let i=this.scrollElement,s=this.targetWindow;if(i===null||s===null)return;let r="document"in i?i.document.scrollingElement:i;if(!r?.style)return;if(this._momentumStop){this._momentumStop.done=t;return}let{style:o}=r,a=this.options.horizontal?"overflow-x":"overflow-y",l=o.getPropertyValue(a),c=o.getPropertyPriority(a),u=()=>this.options.horizontal?r.clientHeight:r.clientWidth,h=u();if(o.setProperty(a,"hidden","important"),u()!==h){o.setProperty(a,l,c);return}let f={restore:()=>o.getPropertyValue(a)!=="hidden"||o.getPropertyPriority(a)!=="important"?!1:(o.setProperty(a,l,c),!0),done:t};this._momentumStop=f,s.requestAnimationFrame(()=>s.requestAnimationFrame(()=>{this._momentumStop===f&&(this._momentumStop=null,f.restore()&&f.done())}))},this._clampedBy=t=>{let i=this._elementMaxScrollOffset();if(i===null)return null;let s=i+this._holdOffset;return t>s+.5?{target:t,maxAtWrite:s}:null},this.getVirtualDistanceFromEnd=()=>Math.max(this._getLayoutTotalSize()+this.options.scrollMargin-this.getSize()-this.getScrollOffset(),0),this.getDistanceFromEnd=()=>Math.max(this.getMaxScrollOffset()-this.getScrollOffset(),0),this.isAtEnd=(t=this.options.scrollEndThreshold)=>this.getDistanceFromEnd()<=t,this.getOffsetForAlignment=(t,i,s=0)=>{if(!this.scrollElement)return 0;let r=this.getSize(),o=this.getScrollOffset();i==="auto"&&(i=t>=o+r?"end":"start"),i==="center"?t+=(s-r)/2:i==="end"&&(t-=r);let a=this.getMaxScrollOffset();return Math.max(Math.min(a,t),0)},this.getOffsetForIndex=(t,i="auto")=>{t=Math.max(0,Math.min(t,this.options.count-1));let s=this.getSize(),r=this.getScrollOffset(),o=this.getMeasurements()[t];if(!o)return;if(i==="auto")if(o.end>=r+s-this.options.scrollPaddingEnd)i="end";else if(o.start<=r+this.options.scrollPaddingStart)i="start";else return[r,i];if(i==="end"&&t===this.options.count-1){let l=this.getMaxScrollOffset(),c=l-this.options.paddingEnd+this.options.scrollPaddingEnd;return[Math.max(Math.min(c,l),0),i]}let a=i==="end"?o.end+this.options.scrollPaddingEnd:o.start-this.options.scrollPaddingStart;return[this.getOffsetForAlignment(a,i,o.size),i]},this.scrollToOffset=(t,{align:i="start",behavior:s="auto"}={})=>{this._startScroll({index:null,align:i},this.getOffsetForAlignment(t,i),s,"absolute")},this.scrollToIndex=(t,{align:i="auto",behavior:s="auto"}={})=>{t=Math.max(0,Math.min(t,this.options.count-1));let r=this.getOffsetForIndex(t,i);if(!r)return;let[o,a]=r;this._startScroll({index:t,align:a},o,s,"absolute")},this.scrollBy=(t,{behavior:i="auto"}={})=>{let s=this.getOffsetForAlignment((this.getCommandWrittenOffset()??this.getScrollOffset())+t,"start");this._startScroll({index:null,align:"start"},s,i,"relative")},this.scrollToEnd=({behavior:t="auto"}={})=>{if(this.options.count>0){this._startScroll({index:this.options.count-1,align:"end",toEnd:!0},Math.max(this.getMaxScrollOffset(),0),t,"absolute");return}this.scrollToOffset(Math.max(this.getTotalSize()-this.getSize(),0),{behavior:t})},this.cancelScroll=()=>{this.rafId!=null&&this.targetWindow&&(this.targetWindow.cancelAnimationFrame(this.rafId),this.rafId=null),this.scrollState=null},this.getTotalSize=()=>Math.max(this._getLayoutTotalSize()-this._holdOffset,0),this._getLayoutTotalSize=()=>{var t,i;let s=this.getMeasurements(),r;if(s.length===0)r=this.options.paddingStart;else if(this.options.lanes===1){let o=s.length-1,a=(t=this._singleLaneMeasurements)==null?void 0:t.flat;a!=null?r=a[o*2]+a[o*2+1]:r=((i=s[o])==null?void 0:i.end)??0}else{let o=Array(this.options.lanes).fill(null),a=s.length-1;for(;a>=0&&o.some(l=>l===null);){let l=s[a];o[l.lane]===null&&(o[l.lane]=l.end),a--}r=Math.max(...o.filter(l=>l!==null))}return Math.max(r-this.options.scrollMargin+this.options.paddingEnd,0)},this.takeSnapshot=()=>{let t=[];if(this.itemSizeCache.size===0)return t;let i=this.getMeasurements();for(let s of i)s&&this.itemSizeCache.has(s.key)&&t.push({index:s.index,key:s.key,start:s.start,size:s.size,end:s.end,lane:s.lane});return t},this._scrollToOffset=(t,{adjustments:i,behavior:s}={})=>{let r={target:t+(i??0),smooth:s==="smooth"};return this.pendingWrite=r,this.options.scrollToFn(t-this._holdOffset,{behavior:s,adjustments:i},this),r},this.getCommandWrittenOffset=()=>this.scrollState!==null&&this.pendingWrite!==null&&!this.pendingWrite.smooth?this.pendingWrite.target:null,this._awaitingCommandReadBack=()=>{let t=this.getCommandWrittenOffset();return!(ka()&&this._iosGesture.dragging())&&t!==null&&!Is(t,this.getScrollOffset())},this._followOffsetTarget=t=>{this.scrollState!==null&&this.scrollState.index==null&&(this.scrollState.lastTargetOffset+=t)},this.measure=()=>{this.pendingMin=null,this.itemSizeCache.clear(),this.laneAssignments.clear(),this.itemSizeCacheVersion++,this.notify(!1)},this.setOptions(e)}get scrollAdjustments(){return 0}applyScrollAdjustment(e,t){if(e===0)return!1;if(this._followOffsetTarget(e),this._canWriteScroll()){let i=this.getScrollOffset();this._clampedAdjustment=this._clampedBy(i+e);let s=this._scrollToOffset(i,{adjustments:e,behavior:t});return this.scrollOffset!==null&&(this.pendingWrite===s&&(this.scrollOffset+=e),this.scrollOffset<0&&(this.scrollOffset=0)),!0}else return this._holdOffset+=e,this.scrollOffset!==null&&(this.scrollOffset+=e),!0}scheduleScrollReconcile(){if(!this.targetWindow){this.scrollState=null;return}this.rafId==null&&(this.rafId=this.targetWindow.requestAnimationFrame(()=>{this.rafId=null,this.reconcileScroll()}))}getScrollStateTarget(e){let t=e.toEnd?[Math.max(this.getMaxScrollOffset(),0)]:e.index!=null?this.getOffsetForIndex(e.index,e.align):void 0;return t?t[0]:e.lastTargetOffset}reconcileScroll(){if(!this.scrollState||!this.scrollElement)return;if(this.now()-this.scrollState.startedAt>5e3){this.scrollState=null;return}if(this.scrollState.phase==="queued"){this.scheduleScrollReconcile();return}this.getMeasurements();let i=this.getScrollStateTarget(this.scrollState),s=this.scrollState.index==null?1:this.options.useAnimationFrameWithResizeObserver?3:2,r=i!==this.scrollState.lastTargetOffset;if(!r&&Is(i,this.getScrollOffset())){if(this.scrollState.phase==="smooth"?this.scrollState.phase="smoothLanded":this.scrollState.phase==="smoothFinishing"&&(this.scrollState.phase="instant"),this.scrollState.stableFrames++,this.scrollState.stableFrames>=s){this.getScrollOffset()!==i&&this._scrollToOffset(i,{behavior:"auto"}),this.scrollState=null;return}}else if(this.scrollState.stableFrames=0,r){let o=this.getSize()||600,a=Math.abs(i-this.getScrollOffset()),l=za(this.scrollState)&&a>o;this.scrollState.lastTargetOffset=i,l?this.scrollState.phase="smooth":this.scrollState.phase==="smooth"?this.scrollState.phase="smoothFinishing":this.scrollState.phase==="smoothLanded"&&(this.scrollState.phase="instant"),this._scrollToOffset(i,{behavior:l?"smooth":"auto"})}this.scheduleScrollReconcile()}_startScroll(e,t,i,s){this.pendingScrollAnchor=null,this._clampedAdjustment=null;let r=this._iosGesture.tail();if(s==="absolute"&&r!==null){if(r==="fling"&&ug()){this._stopMomentum(()=>{let o=this.scrollState;o?.phase!=="queued"||this._iosGesture.tail()!=="fling"||this._reportedOverscroll||(this._iosGesture.end(),this._flushHoldIfReady(!0),this._writeAwaitingCommand())}),this.scrollState={...e,startedAt:this.now(),lastTargetOffset:t,stableFrames:0,phase:"queued",behavior:i,samples:[]},this.scheduleScrollReconcile();return}this._iosGesture.end()}this.scrollState={...e,startedAt:this.now(),lastTargetOffset:t,stableFrames:0,behavior:i,phase:dg(i,e.index!=null&&Is(t,this.getScrollOffset()))},this._scrollToOffset(t,{behavior:i}),this.scheduleScrollReconcile()}},xg=(n,e,t,i)=>{for(;n<=e;){let s=(n+e)/2|0,r=t(s);if(r<i)n=s+1;else if(r>i)e=s-1;else return s}return n>0?n-1:0};function nb(n,e,t){let i=0;for(;i<=e;){let s=(i+e)/2|0,r=n[s*2];if(r<t)i=s+1;else if(r>t)e=s-1;else return s}return i>0?i-1:0}function ib(n,e,t,i,s){let r=n.length-1;if(n.length<=i)return{startIndex:0,endIndex:r};if(i===1&&s!==null){let c=nb(s,r,t),u=c,h=t+e;for(;u<r&&s[u*2]+s[u*2+1]<h;)u++;return{startIndex:c,endIndex:u}}let a=xg(0,r,c=>n[c].start,t),l=a;if(i===1)for(;l<r&&n[l].end<t+e;)l++;else if(i>1){let c=Array(i).fill(0);for(;l<r&&c.some(h=>h<t+e);){let h=n[l];c[h.lane]=h.end,l++}let u=Array(i).fill(t+e);for(;a>=0&&u.some(h=>h>=t);){let h=n[a];u[h.lane]=h.start,a--}a=Math.max(0,a-a%i),l=Math.min(r,l+(i-1-l%i))}return{startIndex:a,endIndex:l}}var Va=class extends Error{constructor(e,t){super(e),this.name="ParseError",this.type=t.type,this.field=t.field,this.value=t.value,this.line=t.line}},vg=10,sb=13,Br=32;function Pf(n){}function Sg(n){if(typeof n=="function")throw new TypeError("`config` must be an object, got a function instead. Did you mean `createParser({onEvent: fn})`?");let{onEvent:e=Pf,onError:t=Pf,onRetry:i=Pf,onComment:s,maxBufferSize:r}=n,o=[],a=0,l=!0,c,u="",h=0,f,d=!1;function x(M){if(d)throw new Error("Cannot feed parser: it was terminated after exceeding the configured max buffer size. Call `reset()` to resume parsing.");if(l&&(l=!1,M.charCodeAt(0)===239&&M.charCodeAt(1)===187&&M.charCodeAt(2)===191&&(M=M.slice(3))),o.length===0){let T=p(M);T!==""&&(o.push(T),a=T.length),y();return}if(M.indexOf(`
`)===-1&&M.indexOf("\r")===-1){o.push(M),a+=M.length,y();return}o.push(M);let w=o.join("");o.length=0,a=0;let g=p(w);g!==""&&(o.push(g),a=g.length),y()}function y(){r!==void 0&&(a+u.length<=r||(d=!0,o.length=0,a=0,c=void 0,u="",h=0,f=void 0,t(new Va(`Buffered data exceeded max buffer size of ${r} characters`,{type:"max-buffer-size-exceeded"}))))}function p(M){let w=0;if(M.indexOf("\r")===-1){let g=M.indexOf(`
`,w);for(;g!==-1;){if(w===g){h>0&&e({id:c,event:f,data:u}),c=void 0,u="",h=0,f=void 0,w=g+1,g=M.indexOf(`
`,w);continue}let T=M.charCodeAt(w);if(yg(M,w,T)){let L=M.charCodeAt(w+5)===Br?w+6:w+5,P=M.slice(L,g);if(h===0&&M.charCodeAt(g+1)===vg){e({id:c,event:f,data:P}),c=void 0,u="",f=void 0,w=g+2,g=M.indexOf(`
`,w);continue}u=h===0?P:`${u}
${P}`,h++}else bg(M,w,T)?f=M.slice(M.charCodeAt(w+6)===Br?w+7:w+6,g)||void 0:m(M,w,g);w=g+1,g=M.indexOf(`
`,w)}return M.slice(w)}for(;w<M.length;){let g=M.indexOf("\r",w),T=M.indexOf(`
`,w),L=-1;if(g!==-1&&T!==-1?L=g<T?g:T:g!==-1?g===M.length-1?L=-1:L=g:T!==-1&&(L=T),L===-1)break;m(M,w,L),w=L+1,M.charCodeAt(w-1)===sb&&M.charCodeAt(w)===vg&&w++}return M.slice(w)}function m(M,w,g){if(w===g){S();return}let T=M.charCodeAt(w);if(yg(M,w,T)){let N=M.charCodeAt(w+5)===Br?w+6:w+5,G=M.slice(N,g);u=h===0?G:`${u}
${G}`,h++;return}if(bg(M,w,T)){f=M.slice(M.charCodeAt(w+6)===Br?w+7:w+6,g)||void 0;return}if(T===105&&M.charCodeAt(w+1)===100&&M.charCodeAt(w+2)===58){let N=M.slice(M.charCodeAt(w+3)===Br?w+4:w+3,g);N.includes("\0")||(c=N);return}if(T===58){if(s){let N=M.slice(w,g);s(N.slice(M.charCodeAt(w+1)===Br?2:1))}return}let L=M.slice(w,g),P=L.indexOf(":");if(P===-1){_(L,"",L);return}let D=L.slice(0,P),I=L.charCodeAt(P+1)===Br?2:1,U=L.slice(P+I);_(D,U,L)}function _(M,w,g){switch(M){case"event":f=w||void 0;break;case"data":u=h===0?w:`${u}
${w}`,h++;break;case"id":w.includes("\0")||(c=w);break;case"retry":/^\d+$/.test(w)?i(parseInt(w,10)):t(new Va(`Invalid \`retry\` value: "${w}"`,{type:"invalid-retry",value:w,line:g}));break;default:t(new Va(`Unknown field "${M.length>20?`${M.slice(0,20)}…`:M}"`,{type:"unknown-field",field:M,value:w,line:g}));break}}function S(){h>0&&e({id:c,event:f,data:u}),c=void 0,u="",h=0,f=void 0}function b(M={}){if(M.consume&&o.length>0){let w=o.join("");m(w,0,w.length)}l=!0,c=void 0,u="",h=0,f=void 0,o.length=0,a=0,d=!1}return{feed:x,reset:b}}function yg(n,e,t){return t===100&&n.charCodeAt(e+1)===97&&n.charCodeAt(e+2)===116&&n.charCodeAt(e+3)===97&&n.charCodeAt(e+4)===58}function bg(n,e,t){return t===101&&n.charCodeAt(e+1)===118&&n.charCodeAt(e+2)===101&&n.charCodeAt(e+3)===110&&n.charCodeAt(e+4)===116&&n.charCodeAt(e+5)===58}var mc=class extends TransformStream{constructor({onError:e,onRetry:t,onComment:i,maxBufferSize:s}={}){let r;super({start(o){r=Sg({onEvent:a=>{o.enqueue(a)},onError(a){typeof e=="function"&&e(a),(e==="terminate"||a.type==="max-buffer-size-exceeded")&&o.error(a)},onRetry:t,onComment:i,maxBufferSize:s})},transform(o){r.feed(o)}})}};function kr(n,e){return!n||n.id!==e.id?e:oi(n.state)&&!oi(e.state)?n:n.cancel_requested&&!e.cancel_requested?{...e,cancel_requested:!0}:e}var Hn=(n,e)=>new Promise(t=>{let i=()=>{clearTimeout(s),e.removeEventListener("abort",i),t()},s=setTimeout(i,n);e.addEventListener("abort",i)}),Co=n=>n instanceof hi&&n.problem.status<500&&n.problem.status!==429;async function Ni(n,e){for(let t=500;;t=Math.min(t*2,8e3)){try{return await n()}catch(i){if(e.aborted||Co(i))throw i}await Hn(t,e),e.throwIfAborted()}}var rb=4e4,ob=30;async function Mg(n,e,t){let i,s=0,r=500;for(;!t.aborted;){let o=new AbortController,a=()=>o.abort();t.addEventListener("abort",a,{once:!0});let l=0;try{let c={accept:"text/event-stream"};i!==void 0&&(c["last-event-id"]=i);let u=await si(`v1/jobs/${n}/events`,{headers:c,signal:o.signal,cache:"no-store"});if(u.status===204||u.body===null)return;e.connected(!0),r=500;let h=()=>{clearTimeout(l),l=window.setTimeout(a,rb)},f=new TransformStream({transform(m,_){h(),_.enqueue(m)}}),d=new TextDecoderStream,y=u.body.pipeThrough(f).pipeThrough(d).pipeThrough(new mc).getReader(),p=performance.now();for(;;){let{done:m,value:_}=await y.read();if(m)break;performance.now()-p>ob&&(await Hn(0,o.signal),p=performance.now()),_.id!==void 0&&(i=_.id);let S=JSON.parse(_.data);if(_.event==="trace"){let b=S;b.seq>s&&(s=b.seq,e.trace([b]))}else if(_.event==="progress")e.progress(S.progress??S);else if(e.job(S),_.event==="done")return}}catch(c){if(t.aborted)return;if(Co(c)){e.failed(c);return}}finally{clearTimeout(l),t.removeEventListener("abort",a)}e.connected(!1),await Hn(r,t),r=Math.min(r*2,8e3)}}async function wg(n,e,t,i){let s,r=500;for(;!i.aborted;)try{if(s===void 0){let a=await ab(i);await n(),s=a}let o=await Mt(`v1/changes?since=${s}&wait=20`,i);t(!0),r=500,s=o.next_since,o.changes.length>0&&e(o.changes)}catch(o){if(i.aborted||(t(!1),o instanceof hi&&o.problem.status===401))return;await Hn(r,i),r=Math.min(r*2,8e3)}}async function ab(n){let e=async s=>(await Mt(`v1/changes?since=${s}&limit=1`,n)).changes.length>0,[t,i]=[-1,0];for(;await e(i);)[t,i]=[i,Math.max(1,i*4)];for(;i-t>1;){let s=Math.floor((t+i)/2);await e(s)?t=s:i=s}return i}var lb="uplot",cb="u-hz",ub="u-vt",hb="u-title",fb="u-wrap",db="u-under",pb="u-over",mb="u-axis",Gr="u-off",gb="u-select",_b="u-cursor-x",xb="u-cursor-y",vb="u-cursor-pt",yb="u-legend",bb="u-live",Sb="u-inline",Mb="u-series",wb="u-marker",Tg="u-label",Tb="u-value",Ha="width",Wa="height";var Ag="bottom",Ro="left",If="right",Yf="#000",Eg=Yf+"0",Lf="mousemove",Cg="mousedown",Df="mouseup",Rg="mouseenter",Pg="mouseleave",Ig="dblclick",Ab="resize",Eb="scroll",Lg="change",yc="dppxchange",Jf="--",Fo=typeof window<"u",Bf=Fo?document:null,Io=Fo?window:null,Cb=Fo?navigator:null,Et,gc;function kf(){let n=devicePixelRatio;Et!=n&&(Et=n,gc&&Vf(Lg,gc,kf),gc=matchMedia(`(min-resolution: ${Et-.001}dppx) and (max-resolution: ${Et+.001}dppx)`),Hr(Lg,gc,kf),Io.dispatchEvent(new CustomEvent(yc)))}function Si(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function zf(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Zt(n,e,t){n.style[e]=t+"px"}function Xi(n,e,t,i){let s=Bf.createElement(n);return e!=null&&Si(s,e),t?.insertBefore(s,i),s}function Oi(n,e){return Xi("div",n,e)}var Dg=new WeakMap;function ps(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Dg.get(n);r!=o&&(n.style.transform=r,Dg.set(n,r),e<0||t<0||e>i||t>s?Si(n,Gr):zf(n,Gr))}var Ng=new WeakMap;function Og(n,e,t){let i=e+t,s=Ng.get(n);i!=s&&(Ng.set(n,i),n.style.background=e,n.style.borderColor=t)}var Fg=new WeakMap;function Ug(n,e,t,i){let s=e+""+t,r=Fg.get(n);s!=r&&(Fg.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var jf={passive:!0},Rb={...jf,capture:!0};function Hr(n,e,t,i){e.addEventListener(n,t,i?Rb:jf)}function Vf(n,e,t,i){e.removeEventListener(n,t,jf)}Fo&&kf();function qi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:Mi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function h0(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var f0=n=>n!=null,d0=n=>n!=null&&n>0,Mc=h0(f0),Pb=h0(d0);function Ib(n,e,t,i=0,s=!1){let r=s?Pb:Mc,o=s?d0:f0;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Vt,l??-Vt]}function wc(n,e,t,i){let s=zg(n),r=zg(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ls:p0,a=s==1?Mi:Fi,l=r==1?Fi:Mi,c=a(o(En(n))),u=l(o(En(e))),h=Lo(t,c),f=Lo(t,u);return t==10&&(c<0&&(h=Gt(h,-c)),u<0&&(f=Gt(f,-u))),i||t==2?(n=h*s,e=f*r):(n=x0(n,h),e=Tc(e,f)),[n,e]}function Zf(n,e,t,i){let s=wc(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Kf=.1,Bg={mode:3,pad:Kf},qa={pad:0,soft:null,mode:0},Lb={min:qa,max:qa};function bc(n,e,t,i){return Ac(t)?kg(n,e,t):(qa.pad=t,qa.soft=i?0:null,qa.mode=i?3:0,kg(n,e,Lb))}function Tt(n,e){return n??e}function Db(n,e,t){for(e=Tt(e,0),t=Tt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function kg(n,e,t){let i=t.min,s=t.max,r=Tt(i.pad,0),o=Tt(s.pad,0),a=Tt(i.hard,-Vt),l=Tt(s.hard,Vt),c=Tt(i.soft,Vt),u=Tt(s.soft,-Vt),h=Tt(i.mode,0),f=Tt(s.mode,0),d=e-n,x=Ls(d),y=li(En(n),En(e)),p=Ls(y),m=En(p-x);(d<1e-24||m>10)&&(d=0,(n==0||e==0)&&(d=1e-24,h==2&&c!=Vt&&(r=0),f==2&&u!=-Vt&&(o=0)));let _=d||y||1e3,S=Ls(_),b=Lo(10,Mi(S)),M=_*(d==0?n==0?.1:1:r),w=Gt(x0(n-M,b/10),24),g=n>=c&&(h==1||h==3&&w<=c||h==2&&w>=c)?c:Vt,T=li(a,w<g&&n>=g?g:$i(g,w)),L=_*(d==0?e==0?.1:1:o),P=Gt(Tc(e+L,b/10),24),D=e<=u&&(f==1||f==3&&P>=u||f==2&&P<=u)?u:-Vt,I=$i(l,P>D&&e<=D?D:li(D,P));return T==I&&T==0&&(I=100),[T,I]}var Nb=new Intl.NumberFormat(Fo?Cb.language:"en-US"),Qf=n=>Nb.format(n),wi=Math,vc=wi.PI,En=wi.abs,Mi=wi.floor,An=wi.round,Fi=wi.ceil,$i=wi.min,li=wi.max,Lo=wi.pow,zg=wi.sign,Ls=wi.log10,p0=wi.log2,Ob=(n,e=1)=>wi.sinh(n)*e,Nf=(n,e=1)=>wi.asinh(n/e),Vt=1/0;function Vg(n){return(Ls((n^n>>31)-(n>>31))|0)+1}function Gf(n,e,t){return $i(li(n,e),t)}function m0(n){return typeof n=="function"}function vt(n){return m0(n)?n:()=>n}var Fb=()=>{},g0=n=>n,_0=(n,e)=>e,Ub=n=>null,Gg=n=>!0,Hg=(n,e)=>n==e,Bb=/\.\d*?(?=9{6,}|0{6,})/gm,Wr=n=>{if(y0(n)||hr.has(n))return n;let e=`${n}`,t=e.match(Bb);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Wr(s)}e${r}`}return Gt(n,i)};function zr(n,e){return Wr(Gt(Wr(n/e))*e)}function Tc(n,e){return Wr(Fi(Wr(n/e))*e)}function x0(n,e){return Wr(Mi(Wr(n/e))*e)}function Gt(n,e=0){if(y0(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return An(i)/t}var hr=new Map;function v0(n){return((""+n).split(".")[1]||"").length}function Ya(n,e,t,i){let s=[],r=i.map(v0);for(let o=e;o<t;o++){let a=En(o),l=Gt(Lo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:Gt(u,h);s.push(f),hr.set(f,h)}}return s}var $a={},ed=[],Do=[null,null],ur=Array.isArray,y0=Number.isInteger,kb=n=>n===void 0;function Wg(n){return typeof n=="string"}function Ac(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function zb(n){return n!=null&&typeof n=="object"}var Vb=Object.getPrototypeOf(Uint8Array),b0="__proto__";function No(n,e=Ac){let t;if(ur(n)){let i=n.find(s=>s!=null);if(ur(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=No(n[s],e)}else t=n.slice()}else if(n instanceof Vb)t=n.slice();else if(e(n)){t={};for(let i in n)i!=b0&&(t[i]=No(n[i],e))}else t=n;return t}function yn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=b0&&(Ac(n[s])?yn(n[s],No(i[s])):n[s]=No(i[s]))}return n}var Gb=0,Hb=1,Wb=2;function Xb(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function qb(n,e){if(Jb(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return jb(o[0])||(o=Yb(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:Hb,d=[];for(let x=0;x<u.length;x++){let y=u[x],p=r.get(l[x]);y===null?f!=Gb&&(h[p]=y,f==Wb&&d.push(p)):h[p]=y}Xb(h,d,s),i.push(h)}}return i}var $b=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Yb(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Jb(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function jb(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=li(1,Mi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var S0=["January","February","March","April","May","June","July","August","September","October","November","December"],M0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function w0(n){return n.slice(0,3)}var Zb=M0.map(w0),Kb=S0.map(w0),Qb={MMMM:S0,MMM:Kb,WWWW:M0,WWW:Zb};function Ga(n){return(n<10?"0":"")+n}function eS(n){return(n<10?"00":n<100?"0":"")+n}var tS={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Ga(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ga(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Ga(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ga(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ga(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>eS(n.getMilliseconds())};function td(n,e){e=e||Qb;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?tS[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var nS=new Intl.DateTimeFormat().resolvedOptions().timeZone;function iS(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==nS?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var T0=n=>n%1==0,Sc=[1,2,2.5,5],sS=Ya(10,-32,0,Sc),A0=Ya(10,0,32,Sc),rS=A0.filter(T0),Vr=sS.concat(A0),nd=`
`,E0="{YYYY}",Xg=nd+E0,C0="{M}/{D}",Xa=nd+C0,_c=Xa+"/{YY}",R0="{aa}",oS="{h}:{mm}",Po=oS+R0,qg=nd+Po,$g=":{ss}",Rt=null;function P0(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ya(10,0,3,Sc).filter(T0):Ya(10,-3,0,Sc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,E0,Rt,Rt,Rt,Rt,Rt,Rt,1],[s*28,"{MMM}",Xg,Rt,Rt,Rt,Rt,Rt,1],[s,C0,Xg,Rt,Rt,Rt,Rt,Rt,1],[i,"{h}"+R0,_c,Rt,Xa,Rt,Rt,Rt,1],[t,Po,_c,Rt,Xa,Rt,Rt,Rt,1],[e,$g,_c+" "+Po,Rt,Xa+" "+Po,Rt,qg,Rt,1],[n,$g+".{fff}",_c+" "+Po,Rt,Xa+" "+Po,Rt,qg,Rt,1]];function u(h){return(f,d,x,y,p,m)=>{let _=[],S=p>=o,b=p>=r&&p<o,M=h(x),w=Gt(M*n,3),g=Of(M.getFullYear(),S?0:M.getMonth(),b||S?1:M.getDate()),T=Gt(g*n,3);if(b||S){let L=b?p/r:0,P=S?p/o:0,D=w==T?w:Gt(Of(g.getFullYear()+P,g.getMonth()+L,1)*n,3),I=new Date(An(D/n)),U=I.getFullYear(),N=I.getMonth();for(let G=0;D<=y;G++){let Y=Of(U+P*G,N+L*G,1),k=Y-h(Gt(Y*n,3));D=Gt((+Y+k)*n,3),D<=y&&_.push(D)}}else{let L=p>=s?s:p,P=Mi(x)-Mi(w),D=T+P+Tc(w-T,L);_.push(D);let I=h(D),U=I.getHours()+I.getMinutes()/t+I.getSeconds()/i,N=p/i,G=f.axes[d]._space,Y=m/G;for(;D=Gt(D+p,n==1?0:3),!(D>y);)if(N>1){let k=Mi(Gt(U+N,6))%24,Z=h(D).getHours()-k;Z>1&&(Z=-1),D-=Z*i,U=(U+N)%24;let q=_[_.length-1];Gt((D-q)/p,3)*Y>=.7&&_.push(D)}else _.push(D)}return _}}return[l,c,u]}var[aS,lS,cS]=P0(1),[uS,hS,fS]=P0(.001);Ya(2,-53,53,[1]);function Yg(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Jg(n,e){return(t,i,s,r,o)=>{let a=e.find(x=>o>=x[0])||e[e.length-1],l,c,u,h,f,d;return i.map(x=>{let y=n(x),p=y.getFullYear(),m=y.getMonth(),_=y.getDate(),S=y.getHours(),b=y.getMinutes(),M=y.getSeconds(),w=p!=l&&a[2]||m!=c&&a[3]||_!=u&&a[4]||S!=h&&a[5]||b!=f&&a[6]||M!=d&&a[7]||a[1];return l=p,c=m,u=_,h=S,f=b,d=M,w(y)})}}function dS(n,e){let t=td(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Of(n,e,t){return new Date(n,e,t)}function jg(n,e){return e(n)}var pS="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Zg(n,e){return(t,i,s,r)=>r==null?Jf:e(n(i))}function mS(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function gS(n,e){return n.series[e].fill(n,e)}var _S={show:!0,live:!0,isolate:!1,mount:Fb,markers:{show:!0,width:2,stroke:mS,fill:gS,dash:"solid"},idx:null,idxs:null,values:[]};function xS(n,e){let t=n.cursor.points,i=Oi(),s=t.size(n,e);Zt(i,Ha,s),Zt(i,Wa,s);let r=s/-2;Zt(i,"marginLeft",r),Zt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Zt(i,"borderWidth",o),i}function vS(n,e){let t=n.series[e].points;return t._fill||t._stroke}function yS(n,e){let t=n.series[e].points;return t._stroke||t._fill}function bS(n,e){return n.series[e].points.size}var Ff=[0,0];function SS(n,e,t){return Ff[0]=e,Ff[1]=t,Ff}function xc(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Uf(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var MS={show:!0,x:!0,y:!0,lock:!1,move:SS,points:{one:!1,show:xS,size:bS,width:0,stroke:yS,fill:vS},bind:{mousedown:xc,mouseup:xc,click:xc,dblclick:xc,mousemove:Uf,mouseleave:Uf,mouseenter:Uf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},I0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},id=yn({},I0,{filter:_0}),L0=yn({},id,{size:10}),D0=yn({},I0,{show:!1}),sd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',N0="bold "+sd,O0=1.5,Kg={show:!0,scale:"x",stroke:Yf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:N0,side:2,grid:id,ticks:L0,border:D0,font:sd,lineGap:O0,rotate:0},wS="Value",TS="Time",Qg={show:!0,scale:"x",auto:!1,sorted:1,min:Vt,max:-Vt,idxs:[]};function AS(n,e,t,i,s){return e.map(r=>r==null?"":Qf(r))}function ES(n,e,t,i,s,r,o){let a=[],l=hr.get(s)||0;t=o?t:Gt(Tc(t,s),l);for(let c=t;c<=i;c=Gt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Hf(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ls:p0,u=Mi(c(t));s=Lo(l,u),l==10&&(s=Vr[qi(s,Vr)]);let h=t,f=s*l;l==10&&(f=Vr[qi(f,Vr)]);do a.push(h),h=h+s,l==10&&!hr.has(h)&&(h=Gt(h,hr.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Vr[qi(f,Vr)]));while(h<=i);return a}function CS(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Hf(n,e,li(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Hf(n,e,li(l,-i),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var F0=/./,RS=/[12357]/,PS=/[125]/,e0=/1/,Wf=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function IS(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?F0:l(7,o)-u>=c?RS:l(5,o)-u>=c?PS:e0;if(h==e0){let f=En(l(1,o)-u);if(f<c)return Wf(e.slice().reverse(),a.distr,h,Fi(c/f)).reverse()}return Wf(e,a.distr,h,1)}function LS(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=En(l(1,o)-l(2,o));return c<a?Wf(e.slice().reverse(),3,F0,Fi(a/c)).reverse():e}function DS(n,e,t,i){return i==null?Jf:e==null?"":Qf(e)}var t0={show:!0,scale:"y",stroke:Yf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:N0,side:3,grid:id,ticks:L0,border:D0,font:sd,lineGap:O0,rotate:0};function NS(n,e){let t=3+(n||1)*2;return Gt(t*e,3)}function OS(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=En(o-r),l=n.series[e],c=a/(l.points.space*Et);return i[1]-i[0]<=c}var n0={scale:null,auto:!0,sorted:0,min:Vt,max:-Vt},U0=(n,e,t,i,s)=>s,i0={show:!0,auto:!0,sorted:0,gaps:U0,alpha:1,facets:[yn({},n0,{scale:"x"}),yn({},n0,{scale:"y"})]},s0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:U0,alpha:1,points:{show:OS,filter:null},values:null,min:Vt,max:-Vt,idxs:[],path:null,clip:null};function FS(n,e,t,i,s){return t/10}var B0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},US=yn({},B0,{time:!1,ori:1}),r0={};function k0(n,e){let t=r0[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(r0[n]=t)),t}var Oo=1,Xf=2;function Xr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,x=a.width,y=a.height,p=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,h,p,m,f,d,x,y,Cc,Uo,Pc,V0,H0):t(s,l,c,u,h,m,p,d,f,y,x,Rc,Bo,ad,G0,W0)}function rd(n,e){let t=0,i=0,s=Tt(n.bands,ed);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function BS(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ds(n,e,t,i,s,r){return Xr(n,e,(o,a,l,c,u,h,f,d,x,y,p)=>{let m=o.pxRound,_=c.dir*(c.ori==0?1:-1),S=c.ori==0?Uo:Bo,b,M;_==1?(b=t,M=i):(b=i,M=t);let w=m(h(a[b],c,y,d)),g=m(f(l[b],u,p,x)),T=m(h(a[M],c,y,d)),L=m(f(r==1?u.max:u.min,u,p,x)),P=new Path2D(s);return S(P,T,L),S(P,w,L),S(P,w,g),P})}function Ec(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Pc:ad,l=t;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function kS(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function od(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=r(n[h]),x=f==h?d:r(n[f]),y=h-s;d=o<=0&&y>=0&&y<l?r(n[y]):d;let m=f+s;x=o>=0&&m>=0&&m<l?r(n[m]):x,x>=d&&a.push([d,x])}return a}function o0(n){return n==0?g0:n==1?An:e=>zr(e,n)}function z0(n){let e=n==0?Cc:Rc,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=$i(c,a/2,l/2),u=$i(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Cc=(n,e,t)=>{n.moveTo(e,t)},Rc=(n,e,t)=>{n.moveTo(t,e)},Uo=(n,e,t)=>{n.lineTo(e,t)},Bo=(n,e,t)=>{n.lineTo(t,e)},Pc=z0(0),ad=z0(1),V0=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},G0=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},H0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},W0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function X0(n){return(e,t,i,s,r)=>Xr(e,t,(o,a,l,c,u,h,f,d,x,y,p)=>{let{pxRound:m,points:_}=o,S,b;c.ori==0?(S=Cc,b=V0):(S=Rc,b=G0);let M=Gt(_.width*Et,3),w=(_.size-_.width)/2*Et,g=Gt(w*2,3),T=new Path2D,L=new Path2D,{left:P,top:D,width:I,height:U}=e.bbox;Pc(L,P-g,D-g,I+g*2,U+g*2);let N=G=>{if(l[G]!=null){let Y=m(h(a[G],c,y,d)),k=m(f(l[G],u,p,x));S(T,Y+w,k),b(T,Y,k,w,0,vc*2)}};if(r)r.forEach(N);else for(let G=i;G<=s;G++)N(G);return{stroke:M>0?T:null,fill:T,clip:L,flags:Oo|Xf}})}function q0(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var zS=q0(Uo),VS=q0(Bo);function $0(n){let e=Tt(n?.alignGaps,0);return(t,i,s,r)=>Xr(t,i,(o,a,l,c,u,h,f,d,x,y,p)=>{[s,r]=Mc(l,s,r);let m=o.pxRound,_=U=>m(h(U,c,y,d)),S=U=>m(f(U,u,p,x)),b,M;c.ori==0?(b=Uo,M=zS):(b=Bo,M=VS);let w=c.dir*(c.ori==0?1:-1),g={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Oo},T=g.stroke,L=!1;if(r-s>=y*4){let U=ne=>t.posToVal(ne,c.key,!0),N=null,G=null,Y,k,se,$=_(a[w==1?s:r]),Z=_(a[s]),q=_(a[r]),ie=U(w==1?Z+1:q-1);for(let ne=w==1?s:r;ne>=s&&ne<=r;ne+=w){let K=a[ne],me=(w==1?K<ie:K>ie)?$:_(K),xe=l[ne];me==$?xe!=null?(k=xe,N==null?(b(T,me,S(k)),Y=N=G=k):k<N?N=k:k>G&&(G=k)):xe===null&&(L=!0):(N!=null&&M(T,$,S(N),S(G),S(Y),S(k)),xe!=null?(k=xe,b(T,me,S(k)),N=G=Y=k):(N=G=null,xe===null&&(L=!0)),$=me,ie=U($+w))}N!=null&&N!=G&&se!=$&&M(T,$,S(N),S(G),S(Y),S(k))}else for(let U=w==1?s:r;U>=s&&U<=r;U+=w){let N=l[U];N===null?L=!0:N!=null&&b(T,_(a[U]),S(N))}let[D,I]=rd(t,i);if(o.fill!=null||D!=0){let U=g.fill=new Path2D(T),N=o.fillTo(t,i,o.min,o.max,D),G=S(N),Y=_(a[s]),k=_(a[r]);w==-1&&([k,Y]=[Y,k]),b(U,k,G),b(U,Y,G)}if(!o.spanGaps){let U=[];L&&U.push(...od(a,l,s,r,w,_,e)),g.gaps=U=o.gaps(t,i,s,r,U),g.clip=Ec(U,c.ori,d,x,y,p)}return I!=0&&(g.band=I==2?[Ds(t,i,s,r,T,-1),Ds(t,i,s,r,T,1)]:Ds(t,i,s,r,T,I)),g})}function GS(n){let e=Tt(n.align,1),t=Tt(n.ascDesc,!1),i=Tt(n.alignGaps,0),s=Tt(n.extend,!1);return(r,o,a,l)=>Xr(r,o,(c,u,h,f,d,x,y,p,m,_,S)=>{[a,l]=Mc(h,a,l);let b=c.pxRound,{left:M,width:w}=r.bbox,g=Z=>b(x(Z,f,_,p)),T=Z=>b(y(Z,d,S,m)),L=f.ori==0?Uo:Bo,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Oo},D=P.stroke,I=f.dir*(f.ori==0?1:-1),U=T(h[I==1?a:l]),N=g(u[I==1?a:l]),G=N,Y=N;s&&e==-1&&(Y=M,L(D,Y,U)),L(D,N,U);for(let Z=I==1?a:l;Z>=a&&Z<=l;Z+=I){let q=h[Z];if(q==null)continue;let ie=g(u[Z]),ne=T(q);e==1?L(D,ie,U):L(D,G,ne),L(D,ie,ne),U=ne,G=ie}let k=G;s&&e==1&&(k=M+w,L(D,k,U));let[se,$]=rd(r,o);if(c.fill!=null||se!=0){let Z=P.fill=new Path2D(D),q=c.fillTo(r,o,c.min,c.max,se),ie=T(q);L(Z,k,ie),L(Z,Y,ie)}if(!c.spanGaps){let Z=[];Z.push(...od(u,h,a,l,I,g,i));let q=c.width*Et/2,ie=t||e==1?q:-q,ne=t||e==-1?-q:q;Z.forEach(K=>{K[0]+=ie,K[1]+=ne}),P.gaps=Z=c.gaps(r,o,a,l,Z),P.clip=Ec(Z,f.ori,p,m,_,S)}return $!=0&&(P.band=$==2?[Ds(r,o,a,l,D,-1),Ds(r,o,a,l,D,1)]:Ds(r,o,a,l,D,$)),P})}function a0(n,e,t,i,s,r,o=Vt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=En(n[l]-n[a]);u<c&&(c=u,o=En(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function HS(n){n=n||$a;let e=Tt(n.size,[.6,Vt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=vt(s),o=1-e[0],a=Tt(e[1],Vt),l=Tt(e[2],1),c=Tt(n.disp,$a),u=Tt(n.each,d=>{}),{fill:h,stroke:f}=c;return(d,x,y,p)=>Xr(d,x,(m,_,S,b,M,w,g,T,L,P,D)=>{let I=m.pxRound,U=t,N=i*Et,G=a*Et,Y=l*Et,k,se;b.ori==0?[k,se]=r(d,x):[se,k]=r(d,x);let $=b.dir*(b.ori==0?1:-1),Z=b.ori==0?Pc:ad,q=b.ori==0?u:(Ie,Je,at,Te,zt,Ge,$e)=>{u(Ie,Je,at,zt,Te,$e,Ge)},ie=Tt(d.bands,ed).find(Ie=>Ie.series[0]==x),ne=ie!=null?ie.dir:0,K=m.fillTo(d,x,m.min,m.max,ne),he=I(g(K,M,D,L)),me,xe,ve,He=P,ot=I(m.width*Et),We=!1,ft=null,ct=null,st=null,Qt=null;h!=null&&(ot==0||f!=null)&&(We=!0,ft=h.values(d,x,y,p),ct=new Map,new Set(ft).forEach(Ie=>{Ie!=null&&ct.set(Ie,new Path2D)}),ot>0&&(st=f.values(d,x,y,p),Qt=new Map,new Set(st).forEach(Ie=>{Ie!=null&&Qt.set(Ie,new Path2D)})));let{x0:Wt,size:dn}=c;if(Wt!=null&&dn!=null){U=1,_=Wt.values(d,x,y,p),Wt.unit==2&&(_=_.map(at=>d.posToVal(T+at*P,b.key,!0)));let Ie=dn.values(d,x,y,p);dn.unit==2?xe=Ie[0]*P:xe=w(Ie[0],b,P,T)-w(0,b,P,T),He=a0(_,S,w,b,P,T,He),ve=He-xe+N}else He=a0(_,S,w,b,P,T,He),ve=He*o+N,xe=He-ve;ve<1&&(ve=0),ot>=xe/2&&(ot=0),ve<5&&(I=g0);let Ut=ve>0,In=He-ve-(Ut?ot:0);xe=I(Gf(In,Y,G)),me=(U==0?xe/2:U==$?0:xe)-U*$*((U==0?N/2:0)+(Ut?ot/2:0));let St={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},wn=We?null:new Path2D,sn=null;if(ie!=null)sn=d.data[ie.series[1]];else{let{y0:Ie,y1:Je}=c;Ie!=null&&Je!=null&&(S=Je.values(d,x,y,p),sn=Ie.values(d,x,y,p))}let pn=k*xe,V=se*xe;for(let Ie=$==1?y:p;Ie>=y&&Ie<=p;Ie+=$){let Je=S[Ie];if(Je==null)continue;if(sn!=null){let J=sn[Ie]??0;if(Je-J==0)continue;he=g(J,M,D,L)}let at=b.distr!=2||c!=null?_[Ie]:Ie,Te=w(at,b,P,T),zt=g(Tt(Je,K),M,D,L),Ge=I(Te-me),$e=I(li(zt,he)),O=I($i(zt,he)),E=$e-O;if(Je!=null){let J=Je<0?V:pn,de=Je<0?pn:V;We?(ot>0&&st[Ie]!=null&&Z(Qt.get(st[Ie]),Ge,O+Mi(ot/2),xe,li(0,E-ot),J,de),ft[Ie]!=null&&Z(ct.get(ft[Ie]),Ge,O+Mi(ot/2),xe,li(0,E-ot),J,de)):Z(wn,Ge,O+Mi(ot/2),xe,li(0,E-ot),J,de),q(d,x,Ie,Ge-ot/2,O,xe+ot,E)}}return ot>0?St.stroke=We?Qt:wn:We||(St._fill=m.width==0?m._fill:m._stroke??m._fill,St.width=0),St.fill=We?ct:wn,St})}function WS(n,e){let t=Tt(e?.alignGaps,0);return(i,s,r,o)=>Xr(i,s,(a,l,c,u,h,f,d,x,y,p,m)=>{[r,o]=Mc(c,r,o);let _=a.pxRound,S=k=>_(f(k,u,p,x)),b=k=>_(d(k,h,m,y)),M,w,g;u.ori==0?(M=Cc,g=Uo,w=H0):(M=Rc,g=Bo,w=W0);let T=u.dir*(u.ori==0?1:-1),L=S(l[T==1?r:o]),P=L,D=[],I=[];for(let k=T==1?r:o;k>=r&&k<=o;k+=T)if(c[k]!=null){let $=l[k],Z=S($);D.push(P=Z),I.push(b(c[k]))}let U={stroke:n(D,I,M,g,w,_),fill:null,clip:null,band:null,gaps:null,flags:Oo},N=U.stroke,[G,Y]=rd(i,s);if(a.fill!=null||G!=0){let k=U.fill=new Path2D(N),se=a.fillTo(i,s,a.min,a.max,G),$=b(se);g(k,P,$),g(k,L,$)}if(!a.spanGaps){let k=[];k.push(...od(l,c,r,o,T,S,t)),U.gaps=k=a.gaps(i,s,r,o,k),U.clip=Ec(k,u.ori,x,y,p,m)}return Y!=0&&(U.band=Y==2?[Ds(i,s,r,o,N,-1),Ds(i,s,r,o,N,1)]:Ds(i,s,r,o,N,Y)),U})}function XS(n){return WS(qS,n)}function qS(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,e[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,n[f+1],e[f+1])}return a}var qf=new Set;function l0(){for(let n of qf)n.syncRect(!0)}Fo&&(Hr(Ab,Io,l0),Hr(Eb,Io,l0,!0),Hr(yc,Io,()=>{Fn.pxRatio=Et}));var $S=$0(),YS=X0();function c0(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>$f(r,o,e,t))}function JS(n,e){return n.map((t,i)=>i==0?{}:yn({},e,t))}function $f(n,e,t,i){return yn({},e==0?t:i,n)}function Y0(n,e,t){return e==null?Do:[e,t]}var jS=Y0;function ZS(n,e,t){return e==null?Do:bc(e,t,Kf,!0)}function J0(n,e,t,i){return e==null?Do:wc(e,t,n.scales[i].log,!1)}var KS=J0;function j0(n,e,t,i){return e==null?Do:Zf(e,t,n.scales[i].log,!1)}var QS=j0;function eM(n,e,t,i,s){let r=li(Vg(n),Vg(e)),o=e-n,a=qi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?hr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function u0(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=An((t=+s)*Et))+"px"),[n,e,t]}function tM(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Gt(e[2]*Et,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Fn(n,e,t){let i={mode:Tt(n.mode,1)},s=i.mode;function r(A,C,F,B){let X=C.valToPct(A);return B+F*(C.dir==-1?1-X:X)}function o(A,C,F,B){let X=C.valToPct(A);return B+F*(C.dir==-1?X:1-X)}function a(A,C,F,B){return C.ori==0?r(A,C,F,B):o(A,C,F,B)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Oi(lb);if(n.id!=null&&(c.id=n.id),Si(c,n.class),n.title){let A=Oi(hb,c);A.textContent=n.title}let u=Xi("canvas"),h=i.ctx=u.getContext("2d"),f=Oi(fb,c);Hr("click",f,A=>{A.target===x&&(qt!=yo||en!=bo)&&zn.click(i,A)},!0);let d=i.under=Oi(db,f);f.appendChild(u);let x=i.over=Oi(pb,f);n=No(n);let y=+Tt(n.pxAlign,1),p=o0(y);(n.plugins||[]).forEach(A=>{A.opts&&(n=A.opts(i,n)||n)});let m=n.ms||.001,_=i.series=s==1?c0(n.series||[],Qg,s0,!1):JS(n.series||[null],i0),S=i.axes=c0(n.axes||[],Kg,t0,!0),b=i.scales={},M=i.bands=n.bands||[];M.forEach(A=>{A.fill=vt(A.fill||null),A.dir=Tt(A.dir,-1)});let w=s==2?_[1].facets[0].scale:_[0].scale,g={axes:Rs,series:pt},T=(n.drawOrder||["axes","series"]).map(A=>g[A]);function L(A){let C=A.distr==3?F=>Ls(F>0?F:A.clamp(i,F,A.min,A.max,A.key)):A.distr==4?F=>Nf(F,A.asinh):A.distr==100?F=>A.fwd(F):F=>F;return F=>{let B=C(F),{_min:X,_max:ee}=A,ue=ee-X;return(B-X)/ue}}function P(A){let C=b[A];if(C==null){let F=(n.scales||$a)[A]||$a;if(F.from!=null){P(F.from);let B=yn({},b[F.from],F,{key:A});B.valToPct=L(B),b[A]=B}else{C=b[A]=yn({},A==w?B0:US,F),C.key=A;let B=C.time,X=C.range,ee=ur(X);if((A!=w||s==2&&!B)&&(ee&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Bg:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Bg:{mode:1,hard:X[1],soft:X[1]}},ee=!1),!ee&&Ac(X))){let ue=X;X=(ge,Me,Oe)=>Me==null?Do:bc(Me,Oe,ue)}C.range=vt(X||(B?jS:A==w?C.distr==3?KS:C.distr==4?QS:Y0:C.distr==3?J0:C.distr==4?j0:ZS)),C.auto=vt(ee?!1:C.auto),C.clamp=vt(C.clamp||FS),C._min=C._max=null,C.valToPct=L(C)}}}P("x"),P("y"),s==1&&_.forEach(A=>{P(A.scale)}),S.forEach(A=>{P(A.scale)});for(let A in n.scales)P(A);let D=b[w],I=D.distr,U,N;D.ori==0?(Si(c,cb),U=r,N=o):(Si(c,ub),U=o,N=r);let G={};for(let A in b){let C=b[A];(C.min!=null||C.max!=null)&&(G[A]={min:C.min,max:C.max},C.min=C.max=null)}let Y=n.tzDate||(A=>new Date(An(A/m))),k=n.fmtDate||td,se=m==1?cS(Y):fS(Y),$=Jg(Y,Yg(m==1?lS:hS,k)),Z=Zg(Y,jg(pS,k)),q=[],ie=i.legend=yn({},_S,n.legend),ne=i.cursor=yn({},MS,{drag:{y:s==2}},n.cursor),K=ie.show,he=ne.show,me=ie.markers;ie.idxs=q,me.width=vt(me.width),me.dash=vt(me.dash),me.stroke=vt(me.stroke),me.fill=vt(me.fill);let xe,ve,He,ot=[],We=[],ft,ct=!1,st={};if(ie.live){let A=_[1]?_[1].values:null;ct=A!=null,ft=ct?A(i,1,0):{_:0};for(let C in ft)st[C]=Jf}if(K)if(xe=Xi("table",yb,c),He=Xi("tbody",null,xe),ie.mount(i,xe),ct){ve=Xi("thead",null,xe,He);let A=Xi("tr",null,ve);Xi("th",null,A);for(var Qt in ft)Xi("th",Tg,A).textContent=Qt}else Si(xe,Sb),ie.live&&Si(xe,bb);let Wt={show:!0},dn={show:!1};function Ut(A,C){if(C==0&&(ct||!ie.live||s==2))return Do;let F=[],B=Xi("tr",Mb,He,He.childNodes[C]);Si(B,A.class),A.show||Si(B,Gr);let X=Xi("th",null,B);if(me.show){let ge=Oi(wb,X);if(C>0){let Me=me.width(i,C);Me&&(ge.style.border=Me+"px "+me.dash(i,C)+" "+me.stroke(i,C)),ge.style.background=me.fill(i,C)}}let ee=Oi(Tg,X);A.label instanceof HTMLElement?ee.appendChild(A.label):ee.textContent=A.label,C>0&&(me.show||(ee.style.color=A.width>0?me.stroke(i,C):me.fill(i,C)),St("click",X,ge=>{if(ne._lock)return;Ke(ge);let Me=_.indexOf(A);if((ge.ctrlKey||ge.metaKey)!=ie.isolate){let Oe=_.some((Fe,Be)=>Be>0&&Be!=Me&&Fe.show);_.forEach((Fe,Be)=>{Be>0&&cs(Be,Oe?Be==Me?Wt:dn:Wt,!0,xn.setSeries)})}else cs(Me,{show:!A.show},!0,xn.setSeries)},!1),Qe&&St(Rg,X,ge=>{ne._lock||(Ke(ge),cs(_.indexOf(A),Mo,!0,xn.setSeries))},!1));for(var ue in ft){let ge=Xi("td",Tb,B);ge.textContent="--",F.push(ge)}return[B,F]}let In=new Map;function St(A,C,F,B=!0){let X=In.get(C)||{},ee=ne.bind[A](i,C,F,B);ee&&(Hr(A,C,X[A]=ee),In.set(C,X))}function wn(A,C,F){let B=In.get(C)||{};for(let X in B)(A==null||X==A)&&(Vf(X,C,B[X]),delete B[X]);A==null&&In.delete(C)}let sn=0,pn=0,V=0,Ie=0,Je=0,at=0,Te=Je,zt=at,Ge=V,$e=Ie,O=0,E=0,J=0,de=0;i.bbox={};let ce=!1,be=!1,Se=!1,re=!1,ae=!1,_e=!1;function z(A,C,F){(F||A!=i.width||C!=i.height)&&le(A,C),ut(!1),Se=!0,be=!0,Gn()}function le(A,C){i.width=sn=V=A,i.height=pn=Ie=C,Je=at=0,we(),Xe();let F=i.bbox;O=F.left=zr(Je*Et,.5),E=F.top=zr(at*Et,.5),J=F.width=zr(V*Et,.5),de=F.height=zr(Ie*Et,.5)}let oe=3;function Ae(){let A=!1,C=0;for(;!A;){C++;let F=_o(C),B=ls(C);A=C==oe||F&&B,A||(le(i.width,i.height),be=!0)}}function ye({width:A,height:C}){z(A,C)}i.setSize=ye;function we(){let A=!1,C=!1,F=!1,B=!1;S.forEach((X,ee)=>{if(X.show&&X._show){let{side:ue,_size:ge}=X,Me=ue%2,Oe=X.label!=null?X.labelSize:0,Fe=ge+Oe;Fe>0&&(Me?(V-=Fe,ue==3?(Je+=Fe,B=!0):F=!0):(Ie-=Fe,ue==0?(at+=Fe,A=!0):C=!0))}}),os[0]=A,os[1]=F,os[2]=C,os[3]=B,V-=Gi[1]+Gi[3],Je+=Gi[3],Ie-=Gi[2]+Gi[0],at+=Gi[0]}function Xe(){let A=Je+V,C=at+Ie,F=Je,B=at;function X(ee,ue){switch(ee){case 1:return A+=ue,A-ue;case 2:return C+=ue,C-ue;case 3:return F-=ue,F+ue;case 0:return B-=ue,B+ue}}S.forEach((ee,ue)=>{if(ee.show&&ee._show){let ge=ee.side;ee._pos=X(ge,ee._size),ee.label!=null&&(ee._lpos=X(ge,ee.labelSize))}})}if(ne.dataIdx==null){let A=ne.hover,C=A.skip=new Set(A.skip??[]);C.add(void 0);let F=A.prox=vt(A.prox),B=A.bias??=0;ne.dataIdx=(X,ee,ue,ge)=>{if(ee==0)return ue;let Me=ue,Oe=F(X,ee,ue,ge)??Vt,Fe=Oe>=0&&Oe<Vt,Be=D.ori==0?V:Ie,rt=ne.left,At=e[0],wt=e[ee];if(C.has(wt[ue])){Me=null;let gt=null,je=null,qe;if(B==0||B==-1)for(qe=ue;gt==null&&qe-- >0;)C.has(wt[qe])||(gt=qe);if(B==0||B==1)for(qe=ue;je==null&&qe++<wt.length;)C.has(wt[qe])||(je=qe);if(gt!=null||je!=null)if(Fe){let Yt=gt==null?-1/0:U(At[gt],D,Be,0),an=je==null?1/0:U(At[je],D,Be,0),On=rt-Yt,Bt=an-rt;On<=Bt?On<=Oe&&(Me=gt):Bt<=Oe&&(Me=je)}else Me=je==null?gt:gt==null?je:ue-gt<=je-ue?gt:je}else Fe&&En(rt-U(At[ue],D,Be,0))>Oe&&(Me=null);return Me}}let Ke=A=>{ne.event=A};ne.idxs=q,ne._lock=!1;let fe=ne.points;fe.show=vt(fe.show),fe.size=vt(fe.size),fe.stroke=vt(fe.stroke),fe.width=vt(fe.width),fe.fill=vt(fe.fill);let ke=i.focus=yn({},n.focus||{alpha:.3},ne.focus),Qe=ke.prox>=0,Pe=Qe&&fe.one,lt=[],Xt=[],Kn=[];function Aa(A,C){let F=fe.show(i,C);if(F instanceof HTMLElement)return Si(F,vb),Si(F,A.class),ps(F,-10,-10,V,Ie),x.insertBefore(F,lt[C]),F}function po(A,C){if(s==1||C>0){let F=s==1&&b[A.scale].time,B=A.value;A.value=F?Wg(B)?Zg(Y,jg(B,k)):B||Z:B||DS,A.label=A.label||(F?TS:wS)}if(Pe||C>0){A.width=A.width==null?1:A.width,A.paths=A.paths||$S||Ub,A.fillTo=vt(A.fillTo||BS),A.pxAlign=+Tt(A.pxAlign,y),A.pxRound=o0(A.pxAlign),A.stroke=vt(A.stroke||null),A.fill=vt(A.fill||null),A._stroke=A._fill=A._paths=A._focus=null;let F=NS(li(1,A.width),1),B=A.points=yn({},{size:F,width:li(1,F*.2),stroke:A.stroke,space:F*2,paths:YS,_stroke:null,_fill:null},A.points);B.show=vt(B.show),B.filter=vt(B.filter),B.fill=vt(B.fill),B.stroke=vt(B.stroke),B.paths=vt(B.paths),B.pxAlign=A.pxAlign}if(K){let F=Ut(A,C);ot.splice(C,0,F[0]),We.splice(C,0,F[1]),ie.values.push(null)}if(he){q.splice(C,0,null);let F=null;Pe?C==0&&(F=Aa(A,C)):C>0&&(F=Aa(A,C)),lt.splice(C,0,F),Xt.splice(C,0,0),Kn.splice(C,0,0)}Nn("addSeries",C)}function nf(A,C){C=C??_.length,A=s==1?$f(A,C,Qg,s0):$f(A,C,{},i0),_.splice(C,0,A),po(_[C],C)}i.addSeries=nf;function $l(A){if(_.splice(A,1),K){ie.values.splice(A,1),We.splice(A,1);let C=ot.splice(A,1)[0];wn(null,C.firstChild),C.remove()}he&&(q.splice(A,1),lt.splice(A,1)[0].remove(),Xt.splice(A,1),Kn.splice(A,1)),Nn("delSeries",A)}i.delSeries=$l;let os=[!1,!1,!1,!1];function As(A,C){if(A._show=A.show,A.show){let F=A.side%2,B=b[A.scale];B==null&&(A.scale=F?_[1].scale:w,B=b[A.scale]);let X=B.time;A.size=vt(A.size),A.space=vt(A.space),A.rotate=vt(A.rotate),ur(A.incrs)&&A.incrs.forEach(ue=>{!hr.has(ue)&&hr.set(ue,v0(ue))}),A.incrs=vt(A.incrs||(B.distr==2?rS:X?m==1?aS:uS:Vr)),A.splits=vt(A.splits||(X&&B.distr==1?se:B.distr==3?Hf:B.distr==4?CS:ES)),A.stroke=vt(A.stroke),A.grid.stroke=vt(A.grid.stroke),A.ticks.stroke=vt(A.ticks.stroke),A.border.stroke=vt(A.border.stroke);let ee=A.values;A.values=ur(ee)&&!ur(ee[0])?vt(ee):X?ur(ee)?Jg(Y,Yg(ee,k)):Wg(ee)?dS(Y,ee):ee||$:ee||AS,A.filter=vt(A.filter||(B.distr>=3&&B.log==10?IS:B.distr==3&&B.log==2?LS:_0)),A.font=u0(A.font),A.labelFont=u0(A.labelFont),A._size=A.size(i,null,C,0),A._space=A._rotate=A._incrs=A._found=A._splits=A._values=null,A._size>0&&(os[C]=!0,A._el=Oi(mb,f))}}function Es(A,C,F,B){let[X,ee,ue,ge]=F,Me=C%2,Oe=0;return Me==0&&(ge||ee)&&(Oe=C==0&&!X||C==2&&!ue?An(Kg.size/3):0),Me==1&&(X||ue)&&(Oe=C==1&&!ee||C==3&&!ge?An(t0.size/2):0),Oe}let Ea=i.padding=(n.padding||[Es,Es,Es,Es]).map(A=>vt(Tt(A,Es))),Gi=i._padding=Ea.map((A,C)=>A(i,C,os,0)),rn,un=null,hn=null,as=s==1?_[0].idxs:null,gi=null,nr=!1;function Ca(A,C){if(e=A??[],i.data=i._data=e,s==2){rn=0;for(let F=1;F<_.length;F++)rn+=e[F][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),gi=e[0],rn=gi.length;let F=e;if(I==2){F=e.slice();let B=F[0]=Array(rn);for(let X=0;X<rn;X++)B[X]=X}i._data=e=F}if(ut(!0),Nn("setData"),I==2&&(Se=!0),C!==!1){let F=D;F.auto(i,nr)?Ra():rr(w,F.min,F.max),re=re||ne.left>=0,_e=!0,Gn()}}i.setData=Ca;function Ra(){nr=!0;let A,C;s==1&&(rn>0?(un=as[0]=0,hn=as[1]=rn-1,A=e[0][un],C=e[0][hn],I==2?(A=un,C=hn):A==C&&(I==3?[A,C]=wc(A,A,D.log,!1):I==4?[A,C]=Zf(A,A,D.log,!1):D.time?C=A+An(86400/m):[A,C]=bc(A,C,Kf,!0))):(un=as[0]=A=null,hn=as[1]=C=null)),rr(w,A,C)}let mo,ir,go,R,H,te,j,Q,Ee,Le;function Ce(A,C,F,B,X,ee){A??=Eg,F??=ed,B??="butt",X??=Eg,ee??="round",A!=mo&&(h.strokeStyle=mo=A),X!=ir&&(h.fillStyle=ir=X),C!=go&&(h.lineWidth=go=C),ee!=H&&(h.lineJoin=H=ee),B!=te&&(h.lineCap=te=B),F!=R&&h.setLineDash(R=F)}function De(A,C,F,B){C!=ir&&(h.fillStyle=ir=C),A!=j&&(h.font=j=A),F!=Q&&(h.textAlign=Q=F),B!=Ee&&(h.textBaseline=Ee=B)}function Ve(A,C,F,B,X=0){if(B.length>0&&A.auto(i,nr)&&(C==null||C.min==null)){let ee=Tt(un,0),ue=Tt(hn,B.length-1),ge=F.min==null?Ib(B,ee,ue,X,A.distr==3):[F.min,F.max];A.min=$i(A.min,F.min=ge[0]),A.max=li(A.max,F.max=ge[1])}}let nt={min:null,max:null};function dt(){for(let B in b){let X=b[B];G[B]==null&&(X.min==null||G[w]!=null&&X.auto(i,nr))&&(G[B]=nt)}for(let B in b){let X=b[B];G[B]==null&&X.from!=null&&G[X.from]!=null&&(G[B]=nt)}G[w]!=null&&ut(!0);let A={};for(let B in G){let X=G[B];if(X!=null){let ee=A[B]=No(b[B],zb);if(X.min!=null)yn(ee,X);else if(B!=w||s==2)if(rn==0&&ee.from==null){let ue=ee.range(i,null,null,B);ee.min=ue[0],ee.max=ue[1]}else ee.min=Vt,ee.max=-Vt}}if(rn>0){_.forEach((B,X)=>{if(s==1){let ee=B.scale,ue=G[ee];if(ue==null)return;let ge=A[ee];if(X==0){let Me=ge.range(i,ge.min,ge.max,ee);ge.min=Me[0],ge.max=Me[1],un=qi(ge.min,e[0]),hn=qi(ge.max,e[0]),hn-un>1&&(e[0][un]<ge.min&&un++,e[0][hn]>ge.max&&hn--),B.min=gi[un],B.max=gi[hn]}else B.show&&B.auto&&Ve(ge,ue,B,e[X],B.sorted);B.idxs[0]=un,B.idxs[1]=hn}else if(X>0&&B.show&&B.auto){let[ee,ue]=B.facets,ge=ee.scale,Me=ue.scale,[Oe,Fe]=e[X],Be=A[ge],rt=A[Me];Be!=null&&Ve(Be,G[ge],ee,Oe,ee.sorted),rt!=null&&Ve(rt,G[Me],ue,Fe,ue.sorted),B.min=ue.min,B.max=ue.max}});for(let B in A){let X=A[B],ee=G[B];if(X.from==null&&(ee==null||ee.min==null)){let ue=X.range(i,X.min==Vt?null:X.min,X.max==-Vt?null:X.max,B);X.min=ue[0],X.max=ue[1]}}}for(let B in A){let X=A[B];if(X.from!=null){let ee=A[X.from];if(ee.min==null)X.min=X.max=null;else{let ue=X.range(i,ee.min,ee.max,B);X.min=ue[0],X.max=ue[1]}}}let C={},F=!1;for(let B in A){let X=A[B],ee=b[B];if(ee.min!=X.min||ee.max!=X.max){ee.min=X.min,ee.max=X.max;let ue=ee.distr;ee._min=ue==3?Ls(ee.min):ue==4?Nf(ee.min,ee.asinh):ue==100?ee.fwd(ee.min):ee.min,ee._max=ue==3?Ls(ee.max):ue==4?Nf(ee.max,ee.asinh):ue==100?ee.fwd(ee.max):ee.max,C[B]=F=!0}}if(F){_.forEach((B,X)=>{s==2?X>0&&C.y&&(B._paths=null):C[B.scale]&&(B._paths=null)});for(let B in C)Se=!0,Nn("setScale",B);he&&ne.left>=0&&(re=_e=!0)}for(let B in G)G[B]=null}function ze(A){let C=Gf(un-1,0,rn-1),F=Gf(hn+1,0,rn-1);for(;A[C]==null&&C>0;)C--;for(;A[F]==null&&F<rn-1;)F++;return[C,F]}function pt(){if(rn>0){let A=_.some(C=>C._focus)&&Le!=ke.alpha;A&&(h.globalAlpha=Le=ke.alpha),_.forEach((C,F)=>{if(F>0&&C.show&&(nn(F,!1),nn(F,!0),C._paths==null)){let B=Le;Le!=C.alpha&&(h.globalAlpha=Le=C.alpha);let X=s==2?[0,e[F][0].length-1]:ze(e[F]);C._paths=C.paths(i,F,X[0],X[1]),Le!=B&&(h.globalAlpha=Le=B)}}),_.forEach((C,F)=>{if(F>0&&C.show){let B=Le;Le!=C.alpha&&(h.globalAlpha=Le=C.alpha),C._paths!=null&&It(F,!1);{let X=C._paths!=null?C._paths.gaps:null,ee=C.points.show(i,F,un,hn,X),ue=C.points.filter(i,F,ee,X);(ee||ue)&&(C.points._paths=C.points.paths(i,F,un,hn,ue),It(F,!0))}Le!=B&&(h.globalAlpha=Le=B),Nn("drawSeries",F)}}),A&&(h.globalAlpha=Le=1)}}function nn(A,C){let F=C?_[A].points:_[A];F._stroke=F.stroke(i,A),F._fill=F.fill(i,A)}function It(A,C){let F=C?_[A].points:_[A],{stroke:B,fill:X,clip:ee,flags:ue,_stroke:ge=F._stroke,_fill:Me=F._fill,_width:Oe=F.width}=F._paths;Oe=Gt(Oe*Et,3);let Fe=null,Be=Oe%2/2;C&&Me==null&&(Me=Oe>0?"#fff":ge);let rt=F.pxAlign==1&&Be>0;if(rt&&h.translate(Be,Be),!C){let At=O-Oe/2,wt=E-Oe/2,gt=J+Oe,je=de+Oe;Fe=new Path2D,Fe.rect(At,wt,gt,je)}C?Ue(ge,Oe,F.dash,F.cap,Me,B,X,ue,ee):Lt(A,ge,Oe,F.dash,F.cap,Me,B,X,ue,Fe,ee),rt&&h.translate(-Be,-Be)}function Lt(A,C,F,B,X,ee,ue,ge,Me,Oe,Fe){let Be=!1;Me!=0&&M.forEach((rt,At)=>{if(rt.series[0]==A){let wt=_[rt.series[1]],gt=e[rt.series[1]],je=(wt._paths||$a).band;ur(je)&&(je=rt.dir==1?je[0]:je[1]);let qe,Yt=null;wt.show&&je&&Db(gt,un,hn)?(Yt=rt.fill(i,At)||ee,qe=wt._paths.clip):je=null,Ue(C,F,B,X,Yt,ue,ge,Me,Oe,Fe,qe,je),Be=!0}}),Be||Ue(C,F,B,X,ee,ue,ge,Me,Oe,Fe)}let Tn=Oo|Xf;function Ue(A,C,F,B,X,ee,ue,ge,Me,Oe,Fe,Be){Ce(A,C,F,B,X),(Me||Oe||Be)&&(h.save(),Me&&h.clip(Me),Oe&&h.clip(Oe)),Be?(ge&Tn)==Tn?(h.clip(Be),Fe&&h.clip(Fe),_t(X,ue),mn(A,ee,C)):ge&Xf?(_t(X,ue),h.clip(Be),mn(A,ee,C)):ge&Oo&&(h.save(),h.clip(Be),Fe&&h.clip(Fe),_t(X,ue),h.restore(),mn(A,ee,C)):(_t(X,ue),mn(A,ee,C)),(Me||Oe||Be)&&h.restore()}function mn(A,C,F){F>0&&(C instanceof Map?C.forEach((B,X)=>{h.strokeStyle=mo=X,h.stroke(B)}):C!=null&&A&&h.stroke(C))}function _t(A,C){C instanceof Map?C.forEach((F,B)=>{h.fillStyle=ir=B,h.fill(F)}):C!=null&&A&&h.fill(C)}function Cs(A,C,F,B){let X=S[A],ee;if(B<=0)ee=[0,0];else{let ue=X._space=X.space(i,A,C,F,B),ge=X._incrs=X.incrs(i,A,C,F,B,ue);ee=eM(C,F,ge,B,ue)}return X._found=ee}function gn(A,C,F,B,X,ee,ue,ge,Me,Oe){let Fe=ue%2/2;y==1&&h.translate(Fe,Fe),Ce(ge,ue,Me,Oe,ge),h.beginPath();let Be,rt,At,wt,gt=X+(B==0||B==3?-ee:ee);F==0?(rt=X,wt=gt):(Be=X,At=gt);for(let je=0;je<A.length;je++)C[je]!=null&&(F==0?Be=At=A[je]:rt=wt=A[je],h.moveTo(Be,rt),h.lineTo(At,wt));h.stroke(),y==1&&h.translate(-Fe,-Fe)}function _o(A){let C=!0;return S.forEach((F,B)=>{if(!F.show)return;let X=b[F.scale];if(X.min==null){F._show&&(C=!1,F._show=!1,ut(!1));return}else F._show||(C=!1,F._show=!0,ut(!1));let ee=F.side,ue=ee%2,{min:ge,max:Me}=X,[Oe,Fe]=Cs(B,ge,Me,ue==0?V:Ie);if(Fe==0)return;let Be=X.distr==2,rt=F._splits=F.splits(i,B,ge,Me,Oe,Fe,Be),At=X.distr==2?rt.map(qe=>gi[qe]):rt,wt=X.distr==2?gi[rt[1]]-gi[rt[0]]:Oe,gt=F._values=F.values(i,F.filter(i,At,B,Fe,wt),B,Fe,wt);F._rotate=ee==2?F.rotate(i,gt,B,Fe):0;let je=F._size;F._size=Fi(F.size(i,gt,B,A)),je!=null&&F._size!=je&&(C=!1)}),C}function ls(A){let C=!0;return Ea.forEach((F,B)=>{let X=F(i,B,os,A);X!=Gi[B]&&(C=!1),Gi[B]=X}),C}function Rs(){for(let A=0;A<S.length;A++){let C=S[A];if(!C.show||!C._show)continue;let F=C.side,B=F%2,X,ee,ue=C.stroke(i,A),ge=F==0||F==3?-1:1,[Me,Oe]=C._found;if(C.label!=null){let ti=C.labelGap*ge,vi=An((C._lpos+ti)*Et);De(C.labelFont[0],ue,"center",F==2?"top":Ag),h.save(),B==1?(X=ee=0,h.translate(vi,An(E+de/2)),h.rotate((F==3?-vc:vc)/2)):(X=An(O+J/2),ee=vi);let Dr=m0(C.label)?C.label(i,A,Me,Oe):C.label;h.fillText(Dr,X,ee),h.restore()}if(Oe==0)continue;let Fe=b[C.scale],Be=B==0?J:de,rt=B==0?O:E,At=C._splits,wt=Fe.distr==2?At.map(ti=>gi[ti]):At,gt=Fe.distr==2?gi[At[1]]-gi[At[0]]:Me,je=C.ticks,qe=C.border,Yt=je.show?je.size:0,an=An(Yt*Et),On=An((C.alignTo==2?C._size-Yt-C.gap:C.gap)*Et),Bt=C._rotate*-vc/180,ln=p(C._pos*Et),_i=(an+On)*ge,ei=ln+_i;ee=B==0?ei:0,X=B==1?ei:0;let Ii=C.font[0],Hi=C.align==1?Ro:C.align==2?If:Bt>0?Ro:Bt<0?If:B==0?"center":F==3?If:Ro,hs=Bt||B==1?"middle":F==2?"top":Ag;De(Ii,ue,Hi,hs);let xi=C.font[1]*C.lineGap,Li=At.map(ti=>p(a(ti,Fe,Be,rt))),Wi=C._values;for(let ti=0;ti<Wi.length;ti++){let vi=Wi[ti];if(vi!=null){B==0?X=Li[ti]:ee=Li[ti],vi=""+vi;let Dr=vi.indexOf(`
`)==-1?[vi]:vi.split(/\n/gm);for(let ni=0;ni<Dr.length;ni++){let Rm=Dr[ni];Bt?(h.save(),h.translate(X,ee+ni*xi),h.rotate(Bt),h.fillText(Rm,0,0),h.restore()):h.fillText(Rm,X,ee+ni*xi)}}}je.show&&gn(Li,je.filter(i,wt,A,Oe,gt),B,F,ln,an,Gt(je.width*Et,3),je.stroke(i,A),je.dash,je.cap);let fs=C.grid;fs.show&&gn(Li,fs.filter(i,wt,A,Oe,gt),B,B==0?2:1,B==0?E:O,B==0?de:J,Gt(fs.width*Et,3),fs.stroke(i,A),fs.dash,fs.cap),qe.show&&gn([ln],[1],B==0?1:0,B==0?1:2,B==1?E:O,B==1?de:J,Gt(qe.width*Et,3),qe.stroke(i,A),qe.dash,qe.cap)}Nn("drawAxes")}function ut(A){_.forEach((C,F)=>{F>0&&(C._paths=null,A&&(s==1?(C.min=null,C.max=null):C.facets.forEach(B=>{B.min=null,B.max=null})))})}let on=!1,Qn=!1,Dt=[];function _n(){Qn=!1;for(let A=0;A<Dt.length;A++)Nn(...Dt[A]);Dt.length=0}function Gn(){on||($b(hm),on=!0)}function Yl(A,C=!1){on=!0,Qn=C,A(i),hm(),C&&Dt.length>0&&queueMicrotask(_n)}i.batch=Yl;function hm(){if(ce&&(dt(),ce=!1),Se&&(Ae(),Se=!1),be){if(Zt(d,Ro,Je),Zt(d,"top",at),Zt(d,Ha,V),Zt(d,Wa,Ie),Zt(x,Ro,Je),Zt(x,"top",at),Zt(x,Ha,V),Zt(x,Wa,Ie),Zt(f,Ha,sn),Zt(f,Wa,pn),u.width=An(sn*Et),u.height=An(pn*Et),S.forEach(({_el:A,_show:C,_size:F,_pos:B,side:X})=>{if(A!=null)if(C){let ee=X===3||X===0?F:0,ue=X%2==1;Zt(A,ue?"left":"top",B-ee),Zt(A,ue?"width":"height",F),Zt(A,ue?"top":"left",ue?at:Je),Zt(A,ue?"height":"width",ue?Ie:V),zf(A,Gr)}else Si(A,Gr)}),mo=ir=go=H=te=j=Q=Ee=R=null,Le=1,La(!0),Je!=Te||at!=zt||V!=Ge||Ie!=$e){ut(!1);let A=V/Ge,C=Ie/$e;if(he&&!re&&ne.left>=0){ne.left*=A,ne.top*=C,xo&&ps(xo,An(ne.left),0,V,Ie),vo&&ps(vo,0,An(ne.top),V,Ie);for(let F=0;F<lt.length;F++){let B=lt[F];B!=null&&(Xt[F]*=A,Kn[F]*=C,ps(B,Fi(Xt[F]),Fi(Kn[F]),V,Ie))}}if($t.show&&!ae&&$t.left>=0&&$t.width>0){$t.left*=A,$t.width*=A,$t.top*=C,$t.height*=C;for(let F in cf)Zt(So,F,$t[F])}Te=Je,zt=at,Ge=V,$e=Ie}Nn("setSize"),be=!1}sn>0&&pn>0&&(h.clearRect(0,0,u.width,u.height),Nn("drawClear"),T.forEach(A=>A()),Nn("draw")),$t.show&&ae&&(Jl($t),ae=!1),he&&re&&(Lr(null,!0,!1),re=!1),ie.show&&ie.live&&_e&&(af(),_e=!1),l||(l=!0,i.status=1,Nn("ready")),nr=!1,on=!1}i.redraw=(A,C)=>{Se=C||!1,A!==!1?rr(w,D.min,D.max):Gn()};function sf(A,C){let F=b[A];if(F.from==null){if(rn==0){let B=F.range(i,C.min,C.max,A);C.min=B[0],C.max=B[1]}if(C.min>C.max){let B=C.min;C.min=C.max,C.max=B}if(rn>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;A==w&&F.distr==2&&rn>0&&(C.min=qi(C.min,e[0]),C.max=qi(C.max,e[0]),C.min==C.max&&C.max++),G[A]=C,ce=!0,Gn()}}i.setScale=sf;let rf,of,xo,vo,fm,dm,yo,bo,pm,mm,qt,en,sr=!1,zn=ne.drag,Ln=zn.x,Dn=zn.y;he&&(ne.x&&(rf=Oi(_b,x)),ne.y&&(of=Oi(xb,x)),D.ori==0?(xo=rf,vo=of):(xo=of,vo=rf),qt=ne.left,en=ne.top);let $t=i.select=yn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),So=$t.show?Oi(gb,$t.over?x:d):null;function Jl(A,C){if($t.show){for(let F in A)$t[F]=A[F],F in cf&&Zt(So,F,A[F]);C!==!1&&Nn("setSelect")}}i.setSelect=Jl;function Sy(A){if(_[A].show)K&&zf(ot[A],Gr);else if(K&&Si(ot[A],Gr),he){let F=Pe?lt[0]:lt[A];F!=null&&ps(F,-10,-10,V,Ie)}}function rr(A,C,F){sf(A,{min:C,max:F})}function cs(A,C,F,B){C.focus!=null&&Ey(A),C.show!=null&&_.forEach((X,ee)=>{ee>0&&(A==ee||A==null)&&(X.show=C.show,Sy(ee),s==2?(rr(X.facets[0].scale,null,null),rr(X.facets[1].scale,null,null)):rr(X.scale,null,null),Gn())}),F!==!1&&Nn("setSeries",A,C),B&&Da("setSeries",i,A,C)}i.setSeries=cs;function My(A,C){yn(M[A],C)}function wy(A,C){A.fill=vt(A.fill||null),A.dir=Tt(A.dir,-1),C=C??M.length,M.splice(C,0,A)}function Ty(A){A==null?M.length=0:M.splice(A,1)}i.addBand=wy,i.setBand=My,i.delBand=Ty;function Ay(A,C){_[A].alpha=C,he&&lt[A]!=null&&(lt[A].style.opacity=C),K&&ot[A]&&(ot[A].style.opacity=C)}let Ps,or,Ir,Mo={focus:!0};function Ey(A){if(A!=Ir){let C=A==null,F=ke.alpha!=1;_.forEach((B,X)=>{if(s==1||X>0){let ee=C||X==0||X==A;B._focus=C?null:ee,F&&Ay(X,ee?1:ke.alpha)}}),Ir=A,F&&Gn()}}K&&Qe&&St(Pg,xe,A=>{ne._lock||(Ke(A),Ir!=null&&cs(null,Mo,!0,xn.setSeries))});function us(A,C,F){let B=b[C];F&&(A=A/Et-(B.ori==1?at:Je));let X=V;B.ori==1&&(X=Ie,A=X-A),B.dir==-1&&(A=X-A);let ee=B._min,ue=B._max,ge=A/X,Me=ee+(ue-ee)*ge,Oe=B.distr;return Oe==3?Lo(10,Me):Oe==4?Ob(Me,B.asinh):Oe==100?B.bwd(Me):Me}function Cy(A,C){let F=us(A,w,C);return qi(F,e[0],un,hn)}i.valToIdx=A=>qi(A,e[0]),i.posToIdx=Cy,i.posToVal=us,i.valToPos=(A,C,F)=>b[C].ori==0?r(A,b[C],F?J:V,F?O:0):o(A,b[C],F?de:Ie,F?E:0),i.setCursor=(A,C,F)=>{qt=A.left,en=A.top,Lr(null,C,F)};function gm(A,C){Zt(So,Ro,$t.left=A),Zt(So,Ha,$t.width=C)}function _m(A,C){Zt(So,"top",$t.top=A),Zt(So,Wa,$t.height=C)}let Pa=D.ori==0?gm:_m,Ia=D.ori==1?gm:_m;function Ry(){if(K&&ie.live)for(let A=s==2?1:0;A<_.length;A++){if(A==0&&ct)continue;let C=ie.values[A],F=0;for(let B in C)We[A][F++].firstChild.nodeValue=C[B]}}function af(A,C){if(A!=null&&(A.idxs?A.idxs.forEach((F,B)=>{q[B]=F}):kb(A.idx)||q.fill(A.idx),ie.idx=q[0]),K&&ie.live){for(let F=0;F<_.length;F++)(F>0||s==1&&!ct)&&Py(F,q[F]);Ry()}_e=!1,C!==!1&&Nn("setLegend")}i.setLegend=af;function Py(A,C){let F=_[A],B=A==0&&I==2?gi:e[A],X;ct?X=F.values(i,A,C)??st:(X=F.value(i,C==null?null:B[C],A,C),X=X==null?st:{_:X}),ie.values[A]=X}function Lr(A,C,F){pm=qt,mm=en,[qt,en]=ne.move(i,qt,en),ne.left=qt,ne.top=en,he&&(xo&&ps(xo,An(qt),0,V,Ie),vo&&ps(vo,0,An(en),V,Ie));let B,X=un>hn;Ps=Vt,or=null;let ee=D.ori==0?V:Ie,ue=D.ori==1?V:Ie;if(qt<0||rn==0||X){B=ne.idx=null;for(let ge=0;ge<_.length;ge++){let Me=lt[ge];Me!=null&&ps(Me,-10,-10,V,Ie)}Qe&&cs(null,Mo,!0,A==null&&xn.setSeries),ie.live&&(q.fill(B),_e=!0)}else{let ge,Me,Oe;s==1&&(ge=D.ori==0?qt:en,Me=us(ge,w),B=ne.idx=qi(Me,e[0],un,hn),Oe=U(e[0][B],D,ee,0));let Fe=-10,Be=-10,rt=0,At=0,wt=!0,gt="",je="";for(let qe=s==2?1:0;qe<_.length;qe++){let Yt=_[qe],an=q[qe],On=an==null?null:s==1?e[qe][an]:e[qe][1][an],Bt=ne.dataIdx(i,qe,B,Me),ln=Bt==null?null:s==1?e[qe][Bt]:e[qe][1][Bt];if(_e=_e||ln!=On||Bt!=an,q[qe]=Bt,qe>0&&Yt.show){let _i=Bt==null?-10:Bt==B?Oe:U(s==1?e[0][Bt]:e[qe][0][Bt],D,ee,0),ei=ln==null?-10:N(ln,s==1?b[Yt.scale]:b[Yt.facets[1].scale],ue,0);if(Qe&&ln!=null){let Ii=D.ori==1?qt:en,Hi=En(ke.dist(i,qe,Bt,ei,Ii));if(Hi<Ps){let hs=ke.bias;if(hs!=0){let xi=us(Ii,Yt.scale),Li=ln>=0?1:-1,Wi=xi>=0?1:-1;Wi==Li&&(Wi==1?hs==1?ln>=xi:ln<=xi:hs==1?ln<=xi:ln>=xi)&&(Ps=Hi,or=qe)}else Ps=Hi,or=qe}}if(_e||Pe){let Ii,Hi;D.ori==0?(Ii=_i,Hi=ei):(Ii=ei,Hi=_i);let hs,xi,Li,Wi,fs,ti,vi=!0,Dr=fe.bbox;if(Dr!=null){vi=!1;let ni=Dr(i,qe);Li=ni.left,Wi=ni.top,hs=ni.width,xi=ni.height}else Li=Ii,Wi=Hi,hs=xi=fe.size(i,qe);if(ti=fe.fill(i,qe),fs=fe.stroke(i,qe),Pe)qe==or&&Ps<=ke.prox&&(Fe=Li,Be=Wi,rt=hs,At=xi,wt=vi,gt=ti,je=fs);else{let ni=lt[qe];ni!=null&&(Xt[qe]=Li,Kn[qe]=Wi,Ug(ni,hs,xi,vi),Og(ni,ti,fs),ps(ni,Fi(Li),Fi(Wi),V,Ie))}}}}if(Pe){let qe=ke.prox,Yt=Ir==null?Ps<=qe:Ps>qe||or!=Ir;if(_e||Yt){let an=lt[0];an!=null&&(Xt[0]=Fe,Kn[0]=Be,Ug(an,rt,At,wt),Og(an,gt,je),ps(an,Fi(Fe),Fi(Be),V,Ie))}}}if($t.show&&sr)if(A!=null){let[ge,Me]=xn.scales,[Oe,Fe]=xn.match,[Be,rt]=A.cursor.sync.scales,At=A.cursor.drag;if(Ln=At._x,Dn=At._y,Ln||Dn){let{left:wt,top:gt,width:je,height:qe}=A.select,Yt=A.scales[Be].ori,an=A.posToVal,On,Bt,ln,_i,ei,Ii=ge!=null&&Oe(ge,Be),Hi=Me!=null&&Fe(Me,rt);Ii&&Ln?(Yt==0?(On=wt,Bt=je):(On=gt,Bt=qe),ln=b[ge],_i=U(an(On,Be),ln,ee,0),ei=U(an(On+Bt,Be),ln,ee,0),Pa($i(_i,ei),En(ei-_i))):Pa(0,ee),Hi&&Dn?(Yt==1?(On=wt,Bt=je):(On=gt,Bt=qe),ln=b[Me],_i=N(an(On,rt),ln,ue,0),ei=N(an(On+Bt,rt),ln,ue,0),Ia($i(_i,ei),En(ei-_i))):Ia(0,ue)}else uf()}else{let ge=En(pm-fm),Me=En(mm-dm);if(D.ori==1){let rt=ge;ge=Me,Me=rt}Ln=zn.x&&ge>=zn.dist,Dn=zn.y&&Me>=zn.dist;let Oe=zn.uni;Oe!=null?Ln&&Dn&&(Ln=ge>=Oe,Dn=Me>=Oe,!Ln&&!Dn&&(Me>ge?Dn=!0:Ln=!0)):zn.x&&zn.y&&(Ln||Dn)&&(Ln=Dn=!0);let Fe,Be;Ln&&(D.ori==0?(Fe=yo,Be=qt):(Fe=bo,Be=en),Pa($i(Fe,Be),En(Be-Fe)),Dn||Ia(0,ue)),Dn&&(D.ori==1?(Fe=yo,Be=qt):(Fe=bo,Be=en),Ia($i(Fe,Be),En(Be-Fe)),Ln||Pa(0,ee)),!Ln&&!Dn&&(Pa(0,0),Ia(0,0))}if(zn._x=Ln,zn._y=Dn,A==null){if(F){if(Cm!=null){let[ge,Me]=xn.scales;xn.values[0]=ge!=null?us(D.ori==0?qt:en,ge):null,xn.values[1]=Me!=null?us(D.ori==1?qt:en,Me):null}Da(Lf,i,qt,en,V,Ie,B)}if(Qe){let ge=F&&xn.setSeries,Me=ke.prox;Ir==null?Ps<=Me&&cs(or,Mo,!0,ge):Ps>Me?cs(null,Mo,!0,ge):or!=Ir&&cs(or,Mo,!0,ge)}}_e&&(ie.idx=B,af()),C!==!1&&Nn("setCursor")}let ar=null;Object.defineProperty(i,"rect",{get(){return ar==null&&La(!1),ar}});function La(A=!1){A?ar=null:(ar=x.getBoundingClientRect(),Nn("syncRect",ar))}function xm(A,C,F,B,X,ee,ue){ne._lock||sr&&A!=null&&A.movementX==0&&A.movementY==0||(lf(A,C,F,B,X,ee,ue,!1,A!=null),A!=null?Lr(null,!0,!0):Lr(C,!0,!1))}function lf(A,C,F,B,X,ee,ue,ge,Me){if(ar==null&&La(!1),Ke(A),A!=null)F=A.clientX-ar.left,B=A.clientY-ar.top;else{if(F<0||B<0){qt=-10,en=-10;return}let[Oe,Fe]=xn.scales,Be=C.cursor.sync,[rt,At]=Be.values,[wt,gt]=Be.scales,[je,qe]=xn.match,Yt=C.axes[0].side%2==1,an=D.ori==0?V:Ie,On=D.ori==1?V:Ie,Bt=Yt?ee:X,ln=Yt?X:ee,_i=Yt?B:F,ei=Yt?F:B;if(wt!=null?F=je(Oe,wt)?a(rt,b[Oe],an,0):-10:F=an*(_i/Bt),gt!=null?B=qe(Fe,gt)?a(At,b[Fe],On,0):-10:B=On*(ei/ln),D.ori==1){let Ii=F;F=B,B=Ii}}Me&&(C==null||C.cursor.event.type==Lf)&&((F<=1||F>=V-1)&&(F=zr(F,V)),(B<=1||B>=Ie-1)&&(B=zr(B,Ie))),ge?(fm=F,dm=B,[yo,bo]=ne.move(i,F,B)):(qt=F,en=B)}let cf={width:0,height:0,left:0,top:0};function uf(){Jl(cf,!1)}let vm,ym,bm,Sm;function Mm(A,C,F,B,X,ee,ue){sr=!0,Ln=Dn=zn._x=zn._y=!1,lf(A,C,F,B,X,ee,ue,!0,!1),A!=null&&(St(Df,Bf,wm,!1),Da(Cg,i,yo,bo,V,Ie,null));let{left:ge,top:Me,width:Oe,height:Fe}=$t;vm=ge,ym=Me,bm=Oe,Sm=Fe}function wm(A,C,F,B,X,ee,ue){sr=zn._x=zn._y=!1,lf(A,C,F,B,X,ee,ue,!1,!0);let{left:ge,top:Me,width:Oe,height:Fe}=$t,Be=Oe>0||Fe>0,rt=vm!=ge||ym!=Me||bm!=Oe||Sm!=Fe;if(Be&&rt&&Jl($t),zn.setScale&&Be&&rt){let At=ge,wt=Oe,gt=Me,je=Fe;if(D.ori==1&&(At=Me,wt=Fe,gt=ge,je=Oe),Ln&&rr(w,us(At,w),us(At+wt,w)),Dn)for(let qe in b){let Yt=b[qe];qe!=w&&Yt.from==null&&Yt.min!=Vt&&rr(qe,us(gt+je,qe),us(gt,qe))}uf()}else ne.lock&&(ne._lock=!ne._lock,Lr(C,!0,A!=null));A!=null&&(wn(Df,Bf),Da(Df,i,qt,en,V,Ie,null))}function Iy(A,C,F,B,X,ee,ue){if(ne._lock)return;Ke(A);let ge=sr;if(sr){let Me=!0,Oe=!0,Fe=10,Be,rt;D.ori==0?(Be=Ln,rt=Dn):(Be=Dn,rt=Ln),Be&&rt&&(Me=qt<=Fe||qt>=V-Fe,Oe=en<=Fe||en>=Ie-Fe),Be&&Me&&(qt=qt<yo?0:V),rt&&Oe&&(en=en<bo?0:Ie),Lr(null,!0,!0),sr=!1}qt=-10,en=-10,q.fill(null),Lr(null,!0,!0),ge&&(sr=ge)}function Tm(A,C,F,B,X,ee,ue){ne._lock||(Ke(A),Ra(),uf(),A!=null&&Da(Ig,i,qt,en,V,Ie,null))}function Am(){S.forEach(tM),z(i.width,i.height,!0)}Hr(yc,Io,Am);let wo={};wo.mousedown=Mm,wo.mousemove=xm,wo.mouseup=wm,wo.dblclick=Tm,wo.setSeries=(A,C,F,B)=>{let X=xn.match[2];F=X(i,C,F),F!=-1&&cs(F,B,!0,!1)},he&&(St(Cg,x,Mm),St(Lf,x,xm),St(Rg,x,A=>{Ke(A),La(!1)}),St(Pg,x,Iy),St(Ig,x,Tm),qf.add(i),i.syncRect=La);let jl=i.hooks=n.hooks||{};function Nn(A,C,F){Qn?Dt.push([A,C,F]):A in jl&&jl[A].forEach(B=>{B.call(null,i,C,F)})}(n.plugins||[]).forEach(A=>{for(let C in A.hooks)jl[C]=(jl[C]||[]).concat(A.hooks[C])});let Em=(A,C,F)=>F,xn=yn({key:null,setSeries:!1,filters:{pub:Gg,sub:Gg},scales:[w,_[1]?_[1].scale:null],match:[Hg,Hg,Em],values:[null,null]},ne.sync);xn.match.length==2&&xn.match.push(Em),ne.sync=xn;let Cm=xn.key,hf=k0(Cm);function Da(A,C,F,B,X,ee,ue){xn.filters.pub(A,C,F,B,X,ee,ue)&&hf.pub(A,C,F,B,X,ee,ue)}hf.sub(i);function Ly(A,C,F,B,X,ee,ue){xn.filters.sub(A,C,F,B,X,ee,ue)&&wo[A](null,C,F,B,X,ee,ue)}i.pub=Ly;function Dy(){hf.unsub(i),qf.delete(i),In.clear(),Vf(yc,Io,Am),c.remove(),xe?.remove(),Nn("destroy")}i.destroy=Dy;function ff(){Nn("init",n,e),Ca(e||n.data,!1),G[w]?sf(w,G[w]):Ra(),ae=$t.show&&($t.width>0||$t.height>0),re=_e=!0,z(n.width,n.height)}return _.forEach(po),S.forEach(As),t?t instanceof HTMLElement?(t.appendChild(c),ff()):t(i,ff):ff(),i}Fn.assign=yn;Fn.fmtNum=Qf;Fn.rangeNum=bc;Fn.rangeLog=wc;Fn.rangeAsinh=Zf;Fn.orient=Xr;Fn.pxRatio=Et;Fn.join=qb;Fn.fmtDate=td,Fn.tzDate=iS;Fn.sync=k0;{Fn.addGap=kS,Fn.clipGaps=Ec;let n=Fn.paths={points:X0};n.linear=$0,n.stepped=GS,n.bars=HS,n.spline=XS}var nM=Symbol.for("pv"),iM=0;function v(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:nM,__v:--iM,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Nt.vnode&&Nt.vnode(c),c}var Wn=({tone:n,children:e})=>v("span",{class:`badge ${n}`,children:e}),sM={queued:"wait",running:"wait",succeeded:"good",failed:"bad",dead:"bad",expired:"bad",cancelled:"neutral"},ko=({state:n})=>v(Wn,{tone:sM[n],children:n}),Yi=({share:n,label:e})=>v("progress",{class:"bar",max:1,value:n,"aria-label":e});function Ht({text:n}){return n===null?null:v("p",{class:"failure",role:"alert",children:n})}function Xn({rows:n}){return v("dl",{class:"facts",children:n.map(([e,t])=>v("div",{children:[v("dt",{children:e}),v("dd",{children:t})]},e))})}function Ui(){let[n,e]=pe(Date.now());return xt(()=>{let t=setInterval(()=>e(Date.now()),1e3);return()=>clearInterval(t)},[]),n}function cn(n,e){xt(()=>{let t=new AbortController;return n(t.signal),()=>t.abort()},e)}function qr(){let[n,e]=pe(0);return xt(()=>{let t=()=>e(s=>s+1),i=matchMedia("(prefers-color-scheme: dark)");return i.addEventListener("change",t),window.addEventListener("theme",t),()=>{i.removeEventListener("change",t),window.removeEventListener("theme",t)}},[]),n}function zo(n){let e=tn(null),t=tn(null),i=tn(n.marks);i.current=n.marks;let s=qr(),r=JSON.stringify([s,n.log,n.series.map(({label:a,color:l,scale:c})=>[a,l,c]),n.height]),o=[n.x,...n.series.map(a=>a.values)];return xt(()=>{let a=e.current,{color:l,borderTopColor:c}=getComputedStyle(a),u={stroke:l,grid:{stroke:c,width:1},ticks:{stroke:c,width:1},font:"12px system-ui",labelFont:"12px system-ui",labelSize:18},h=n.series.some(x=>x.scale==="right"),f=new Fn({width:a.clientWidth||300,height:n.height,scales:{x:{time:!1},y:{distr:n.log?3:1},right:{}},axes:[{...u,label:n.xLabel},{...u,label:n.yLabel,size:58},...h?[{...u,label:n.rightLabel,scale:"right",side:1,size:50,grid:{show:!1}}]:[]],series:[{label:n.xLabel},...n.series.map(({label:x,color:y,dash:p,width:m,scale:_,points:S})=>({label:x,stroke:y,width:m??1.5,dash:p,scale:_??"y",spanGaps:!0,points:{show:S??!1,size:5},fill:n.bars?y:void 0,paths:n.bars?Fn.paths.bars({size:[.9]}):S?()=>null:void 0,value:(b,M)=>M==null?"–":M.toPrecision(4)}))],legend:{live:!n.bars},hooks:{draw:[x=>{let{ctx:y}=x;y.save(),y.strokeStyle=c,y.fillStyle=l,y.font=`${12*devicePixelRatio}px system-ui`;for(let{at:p,text:m}of i.current??[]){let _=x.valToPos(p,"x",!0);y.beginPath(),y.moveTo(_,x.bbox.top),y.lineTo(_,x.bbox.top+x.bbox.height),y.stroke(),y.fillText(m,_+4*devicePixelRatio,x.bbox.top+12*devicePixelRatio)}y.restore()}]}},o,a);t.current=f;let d=new ResizeObserver(()=>f.setSize({width:a.clientWidth,height:n.height}));return d.observe(a),()=>{d.disconnect(),f.destroy()}},[r]),xt(()=>t.current?.setData(o)),v("div",{class:"plot",ref:e,role:"img","aria-label":n.title,"data-points":n.x.length})}function Ic({value:n,take:e,...t}){let[i,s]=pe(null);return v("input",{...t,value:i??n,onInput:r=>s(r.currentTarget.value),onChange:r=>{s(null),e(r.currentTarget.value)}})}function Ns({label:n,checked:e,onChange:t}){return v("label",{class:"check",children:[v("input",{type:"checkbox",checked:e,onChange:t})," ",n]})}function Z0(){let[n="",e=""]=location.hash.replace(/^#\/?/,"").split("?");return{path:n.split("/").filter(Boolean).map(decodeURIComponent),query:new URLSearchParams(e)}}function fr(n,e={},t=!1){let i=Object.entries(e).filter(([,o])=>o!==""),s=new URLSearchParams(i).toString(),r=`#/${n}${s===""?"":`?${s}`}`;t?(history.replaceState(null,"",r),window.dispatchEvent(new HashChangeEvent("hashchange"))):location.hash=r}function K0(){let[n,e]=pe(Z0);return xt(()=>{let t=()=>e(Z0());return window.addEventListener("hashchange",t),()=>window.removeEventListener("hashchange",t)},[]),n}var Lc=n=>{let{id:e,state:t,method:i,priority:s,progress:r,created_at:o,started_at:a,finished_at:l,reliable:c,unreliable_reasons:u,surface_distance:h,batch_id:f,external_ref:d,cancel_requested:x,labels:y}=n;return{id:e,state:t,method:i,priority:s,progress:r,created_at:o,started_at:a,finished_at:l,reliable:c,unreliable_reasons:u,surface_distance:h,batch_id:f,external_ref:d,cancel_requested:x,labels:y}},[Q0,rM]=[100,500],[oM,ld]=[300,2e3],cd=20,aM=44,e_=["state","method","label","external_ref","batch","study","order"];function t_({query:n}){let e=Object.fromEntries(e_.map(M=>[M,n.get(M)??""])),t=JSON.stringify(e),[i,s]=pe([]),[r,o]=pe(""),[a,l]=pe(null),[c,u]=pe(!0),[h,f]=pe([]),[d,x]=pe(!1),y=M=>l(Jt(M)),p=tn(new Map);p.current=ii(()=>new Map(i.map(M=>[M.id,M])),[i]);let m=tn(null);cn(M=>{s([]),o(""),x(!1);let w=new Set,g=async(q,ie)=>{let ne=new Set;w.add(ne);try{let K=await q();M.aborted||ie(K,ne)}finally{w.delete(ne)}},T=(q,ie,ne)=>g(()=>Mt(`v1/jobs${yi({...e,page_size:q,page_token:ie})}`,M),(K,he)=>{ne(K,K.jobs.map(Lc),he),k(K.jobs.map(({id:me})=>me).filter(me=>he.has(me)))}),L=()=>T(Q0,"",(q,ie)=>{s(ne=>{let K=new Map(ne.map(he=>[he.id,he]));return ie.map(he=>kr(K.get(he.id),he))}),o(q.next_page_token),l(null)}),P=!1,D=async q=>{if(!P){P=!0;try{await T(rM,q,(ie,ne)=>{s(K=>[...K,...ne]),o(ie.next_page_token),l(null)})}catch(ie){M.aborted||y(ie)}finally{P=!1}}},I=async()=>{let q=new Set;return e.order==="asc"||await T(Q0,"",(ie,ne,K)=>{q=new Set(ne.map(he=>he.id)),s(he=>{let me=new Map(he.map(xe=>[xe.id,xe]));return[...ne.map(xe=>K.has(xe.id)&&me.get(xe.id)||kr(me.get(xe.id),xe)),...he.filter(xe=>!q.has(xe.id))]})}),q},U=q=>e.state===""||e.state.split(",").includes(q.state),N=async q=>{for(let ie=0;ie<q.length&&!M.aborted;ie+=cd){let ne=[],K=he=>Mt(`v1/jobs/${he}`,M).then(Lc,me=>(Co(me)||ne.push(he),null));await g(()=>Promise.all(q.slice(ie,ie+cd).map(K)),(he,me)=>{let xe=new Map(he.flatMap(ve=>ve===null||me.has(ve.id)?[]:[[ve.id,ve]]));s(ve=>ve.map(He=>kr(He,xe.get(He.id)??He)).filter(U))}),k(ne,ld)}},G=new Set,Y=0,k=(q,ie=oM)=>{q.forEach(ne=>G.add(ne)),G.size>0&&Y===0&&!M.aborted&&(Y=window.setTimeout(()=>{$()},ie))},se=!1,$=async()=>{Y=0;let q=[...G];G.clear();let ie=q.filter(K=>p.current.has(K)),ne=ie.length>cd;if(ne&&se)return k(q,ld);se||=ne;try{let K=ne||ie.length<q.length?await I():new Set;await N(ie.filter(he=>!K.has(he)))}catch(K){Co(K)||k(q,ld)}finally{ne&&(se=!1)}};m.current={more:D,renew:N};let Z=L().catch(q=>{M.aborted||y(q)});wg(async()=>{await Z;try{await L(),x(!0)}catch(q){if(!Co(q))throw q;y(q)}},q=>{let ie=q.map(({job_id:ne})=>ne);for(let ne of w)ie.forEach(K=>ne.add(K));k(ie)},u,M),(async()=>{for(;!M.aborted;){await Hn(2e3,M);let q=[...p.current.values()].filter(ie=>ie.state==="running").slice(0,16);q.length>0&&!document.hidden&&await N(q.map(ie=>ie.id))}})()},[t]),xt(()=>{Mt("v1/methods").then(({methods:M})=>f(M.map(({name:w})=>w)),()=>{})},[]);let _=(M,w)=>fr("jobs",{...e,[M]:w},!0),S=()=>{let{order:M,...w}=e,g=Object.values(w).some(T=>T!=="");confirm(g?"Cancel all queued and running jobs that these filters select?":"Cancel all queued and running jobs?")&&ri("POST",`v1/jobs/cancel${yi({...w,all:g?void 0:"true"})}`).catch(y)},b=e_.some(M=>e[M]!=="");return v("div",{class:"jobs",children:[v("h1",{children:["Jobs ",!c&&v(Wn,{tone:"bad",children:"connection lost, trying again"})]}),v("form",{class:"tools",role:"search","aria-label":"Filters",onSubmit:M=>M.preventDefault(),children:[v("label",{children:["State"," ",v("select",{value:e.state,onChange:M=>_("state",M.currentTarget.value),children:[v("option",{value:"",children:"any"}),lc.map(M=>v("option",{value:M,children:M}))]})]}),v("label",{children:["Method"," ",v("select",{value:e.method,onChange:M=>_("method",M.currentTarget.value),children:[v("option",{value:"",children:"any"}),h.map(M=>v("option",{value:M,children:M}))]})]}),v("label",{children:["Label ",v(Ic,{value:e.label,placeholder:"name:value",take:M=>_("label",M)})]}),v("label",{children:["Reference ",v(Ic,{value:e.external_ref,take:M=>_("external_ref",M)})]}),v("label",{children:["Order"," ",v("select",{value:e.order,onChange:M=>_("order",M.currentTarget.value),children:[v("option",{value:"",children:"newest first"}),v("option",{value:"asc",children:"oldest first"})]})]}),b&&v("button",{type:"button",onClick:()=>fr("jobs",{},!0),children:"Clear filters"}),v("button",{type:"button",onClick:S,children:"Cancel these …"})]}),v(Ht,{text:a}),v(cM,{rows:i,hasMore:r!==void 0,more:d&&r?()=>{m.current?.more(r)}:null,renew:M=>{m.current?.renew(M)},failed:y}),i.length===0&&r===void 0&&v("p",{class:"empty",children:[b?"No job fits these filters.":"There is no job yet."," ",v("a",{href:"#/submit",children:"Submit a pair of surfaces"}),", or the two built-in phantoms."]})]})}function lM(n,e){let[,t]=pe(0),i=tn(null),s={count:n,getScrollElement:()=>e.current,estimateSize:()=>aM,overscan:8,scrollToFn:_g,observeElementRect:mg,observeElementOffset:gg,onChange:()=>t(r=>r+1)};return i.current??=new pc(s),i.current.setOptions(s),xt(()=>i.current._didMount(),[]),xt(()=>i.current._willUpdate()),i.current}function cM({rows:n,hasMore:e,more:t,renew:i,failed:s}){let r=tn(null),o=lM(n.length,r),a=Ui(),l=o.getVirtualItems(),c=l.at(-1)?.index??0;xt(()=>{c>=n.length-12&&t?.()},[t===null,c,n.length]);let u=(y,p)=>{ri("POST",`v1/jobs/${p}/${y}`).then(m=>y==="retry"?fr(`jobs/${m.id}`):i([p]),s)},h=(y,p)=>ri("PATCH",`v1/jobs/${y}`,{priority:p}).then(()=>i([y]),s),f=y=>{let p={ArrowDown:1,j:1,ArrowUp:-1,k:-1,PageDown:12,PageUp:-12}[y.key],m=y.target;if(p===void 0||m.tagName==="INPUT")return;let _=Number(m.closest("tr")?.dataset.index??-1),S=Math.min(n.length-1,Math.max(0,_+p));y.preventDefault(),o.scrollToIndex(S);let b=M=>{let w=r.current?.querySelector(`tr[data-index="${S}"] a`);w?w.focus():M>0&&requestAnimationFrame(()=>b(M-1))};requestAnimationFrame(()=>b(10))},d=l[0]?.start??0,x=Math.max(0,o.getTotalSize()-(l.at(-1)?.end??0));return v("div",{class:"rows",ref:r,onKeyDown:f,tabIndex:0,role:"region","aria-label":"Jobs; arrow keys move from row to row, Enter opens one",children:v("table",{"aria-rowcount":e?-1:n.length+1,children:[v("thead",{children:v("tr",{children:[v("th",{scope:"col",children:"Job"}),v("th",{scope:"col",children:"State"}),v("th",{scope:"col",children:"Verdict"}),v("th",{scope:"col",class:"numeric",children:"Distance"}),v("th",{scope:"col",children:"Energy"}),v("th",{scope:"col",children:"Method"}),v("th",{scope:"col",children:"Age"}),v("th",{scope:"col",children:"Ran for"}),v("th",{scope:"col",children:"Priority"}),v("th",{scope:"col",children:v("span",{class:"quiet",children:"Actions"})})]})}),v("tbody",{children:[d>0&&v("tr",{"aria-hidden":"true",style:{height:`${d}px`}}),l.map(({index:y})=>{let p=n[y];if(p===void 0)return null;let m=fc(p);return v("tr",{"data-index":y,"data-state":p.state,"aria-rowindex":y+2,children:[v("td",{children:[v("a",{href:`#/jobs/${p.id}`,title:p.id,children:v("code",{children:["…",ai(p.id)]})})," ",p.external_ref&&v("span",{class:"soft",children:p.external_ref}),p.batch_id&&v("a",{class:"soft",href:`#/batches/${p.batch_id}`,children:"batch"})]}),v("td",{children:[v(ko,{state:p.state}),p.state==="running"&&v(Yi,{share:p.progress?.fraction??0,label:`Progress: ${jt(p.progress?.phase??"running")}`})]}),v("td",{children:m.text!==""&&v(Wn,{tone:m.tone,children:m.text})}),v("td",{class:"numeric",children:p.surface_distance?bi(p.surface_distance.mean_mm):""}),v("td",{children:v(hM,{id:p.id,state:p.state})}),v("td",{children:p.method}),v("td",{children:ds(p.created_at,a)}),v("td",{children:p.started_at?Di((p.finished_at?Date.parse(p.finished_at):a)-Date.parse(p.started_at)):""}),v("td",{children:p.state==="queued"?v(Ic,{class:"priority",type:"number",min:-100,max:100,value:String(p.priority),"aria-label":`Priority of job ${ai(p.id)}, −100 to 100, higher first`,take:_=>{h(p.id,Number(_))}}):p.priority}),v("td",{children:oi(p.state)?v("button",{"aria-label":`Retry job ${ai(p.id)}`,onClick:()=>u("retry",p.id),children:"Retry"}):v("button",{"aria-label":`Cancel job ${ai(p.id)}`,disabled:p.cancel_requested,onClick:()=>u("cancel",p.id),children:"Cancel"})})]},p.id)}),x>0&&v("tr",{"aria-hidden":"true",style:{height:`${x}px`}})]})]})})}var Ja=new Map,uM=2e3;function hM({id:n,state:e}){let[t,i]=pe(Ja.get(n)??[]);if(cn(l=>{let c=Ja.get(n);i(c??[]),!(e==="queued"||c!==void 0&&oi(e))&&Hn(250,l).then(async()=>{if(l.aborted)return;let u=await Mt(`v1/jobs/${n}/trace?limit=200`,l).catch(()=>null);if(u===null)return;let h=u.points.filter(Fa),d=(h.length>0?h:u.points.filter(({phase:x})=>x==="inference")).flatMap(({energy:x})=>x===void 0?[]:[x]);Ja.size>uM&&Ja.clear(),oi(e)&&Ja.set(n,d),i(d)})},[n,e]),t.length<2)return null;let s=t.map(l=>Math.log(Math.max(l,1e-9))),[r,o]=[Math.min(...s),Math.max(...s)],a=s.map((l,c)=>`${(c/(s.length-1)*78+1).toFixed(1)},${(21-20*(l-r)/(o-r||1)).toFixed(1)}`);return v("svg",{class:"spark",width:"80",height:"22",role:"img","aria-label":`Energy from ${t[0].toPrecision(3)} to ${t.at(-1).toPrecision(3)}`,children:v("polyline",{points:a.join(" ")})})}function i_({batch:n}){let e=Math.max(1,n.n_jobs),t=lc.flatMap(i=>n.counts[i]?[{state:i,n:n.counts[i]}]:[]);return v(Ot,{children:[v("svg",{class:"counts",viewBox:"0 0 100 6",preserveAspectRatio:"none","aria-hidden":"true",children:t.map(({state:i,n:s},r)=>{let o=t.slice(0,r).reduce((a,l)=>a+l.n,0);return v("rect",{class:i,x:100*o/e,width:100*s/e,height:"6"})})}),v("span",{class:"soft",children:t.map(({state:i,n:s})=>`${s.toLocaleString("en")} ${i}`).join(", ")})]})}function s_(){let[n,e]=pe([]),[t,i]=pe(),[s,r]=pe(null),[o,a]=pe(!1),l=Ui(),c=async(u,h)=>{try{let f=await Mt(`v1/batches${yi({page_size:50,page_token:u})}`,h);e(d=>u===void 0?f.batches:[...d,...f.batches]),i(f.next_page_token),a(!0)}catch(f){h?.aborted||r(Jt(f))}};return cn(u=>{(async()=>{for(await c(void 0,u);!u.aborted;)await Hn(5e3,u),!u.aborted&&!document.hidden&&scrollY<200&&await c(void 0,u)})()},[]),v("div",{children:[v("h1",{children:"Batches"}),v(Ht,{text:s}),o&&n.length===0&&v("p",{class:"empty",children:["There is no batch yet. ",v("code",{children:"POST /v1/batches"})," submits one template against many subjects at once; ",v("a",{href:"docs/",children:"the API"})," says how."]}),n.length>0&&v("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Batches",children:v("table",{children:[v("thead",{children:v("tr",{children:[v("th",{scope:"col",children:"Batch"}),v("th",{scope:"col",class:"numeric",children:"Jobs"}),v("th",{scope:"col",children:"States"}),v("th",{scope:"col",children:"Labels"}),v("th",{scope:"col",children:"Age"})]})}),v("tbody",{children:n.map(u=>v("tr",{children:[v("td",{children:v("a",{href:`#/batches/${u.id}`,children:u.external_ref??`…${ai(u.id)}`})}),v("td",{class:"numeric",children:Re(u.n_jobs)}),v("td",{children:v(i_,{batch:u})}),v("td",{children:Object.entries(u.labels).map(([h,f])=>`${h}:${f}`).join(", ")}),v("td",{children:ds(u.created_at,l)})]},u.id))})]})}),t!==void 0&&v("button",{onClick:()=>{c(t)},children:"More"})]})}var Dc=[{name:"Mean distance, mm",of:n=>n.surface_distance?.mean_mm},{name:"95 % within, mm",of:n=>n.surface_distance?.p95_mm},{name:"Largest distance, mm",of:n=>n.surface_distance?.max_mm}];function n_(n){return oi(n.state)?n.state!=="succeeded"?2e9:(n.reliable===!1?1e9:0)+(n.surface_distance?.p95_mm??0):-1}function r_({id:n}){let[e,t]=pe(null),[i,s]=pe([]),[r,o]=pe(null),[a,l]=pe(0);if(cn(y=>{(async()=>{try{let p="";for(;!y.aborted;){let m=await Mt(`v1/batches/${n}${p}`,y);t(m);let _=[],S="";for(;S!==void 0;){let b=await Mt(`v1/batches/${n}/jobs${yi({page_size:500,page_token:S})}`,y);_.push(...b.jobs.map(Lc)),S=b.next_page_token}if(s(_),m.finished)return;p="?wait=20",await Hn(500,y)}}catch(p){y.aborted||o(Jt(p))}})()},[n]),e===null)return r===null?v("p",{class:"loading",children:"Loading the batch …"}):v(Ht,{text:r});let c=Dc[a-1],u=[...i].sort((y,p)=>c?(c.of(p)??-1)-(c.of(y)??-1):n_(p)-n_(y)),h=i.filter(y=>y.state==="succeeded"),f=h.filter(y=>y.reliable===!1).length,d=i.filter(y=>oi(y.state)&&y.state!=="succeeded").length,x=d+f>0?"bad":e.finished?"good":"wait";return v("article",{children:[v("h1",{class:"sub",children:["Batch ",e.external_ref??v("code",{children:n})]}),v("section",{class:`verdict ${x}`,"aria-label":"Verdict",children:[v("span",{class:"mark","aria-hidden":"true",children:x==="good"?"✓":x==="bad"?"✕":"…"}),v("div",{children:[v("p",{class:"title",children:d+f>0?`${d+f} of ${Re(e.n_jobs)} need a look`:e.finished?"All reliable, or not checked":"Running"}),v("p",{children:[f," not reliable, ",d," without a result, ",h.length-f," others succeeded."]}),v(i_,{batch:e})]}),v("div",{class:"actions",children:!e.finished&&v("button",{onClick:()=>ri("POST",`v1/batches/${n}/cancel`).catch(y=>o(Jt(y))),children:"Cancel the rest"})})]}),v(Ht,{text:r}),v("div",{class:"columns three",children:Dc.map(({name:y,of:p})=>v(fM,{name:y,values:h.flatMap(m=>p(m)??[])},y))}),v("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Subjects",children:v("table",{children:[v("thead",{children:v("tr",{children:[v("th",{scope:"col",children:"Subject"}),v("th",{scope:"col",children:"State"}),v("th",{scope:"col","aria-sort":a===0?"descending":void 0,children:v("button",{class:"plain",onClick:()=>l(0),children:"Verdict, worst first"})}),Dc.map(({name:y},p)=>v("th",{scope:"col",class:"numeric","aria-sort":a===p+1?"descending":void 0,children:v("button",{class:"plain",onClick:()=>l(p+1),children:y})},y)),v("th",{scope:"col",children:"Ran for"})]})}),v("tbody",{children:u.slice(0,500).map(y=>{let p=fc(y);return v("tr",{children:[v("td",{children:v("a",{href:`#/jobs/${y.id}`,children:y.external_ref??`…${ai(y.id)}`})}),v("td",{children:v(ko,{state:y.state})}),v("td",{children:p.text!==""&&v(Wn,{tone:p.tone,children:p.text})}),Dc.map(({name:m,of:_})=>v("td",{class:"numeric",children:bi(_(y))},m)),v("td",{children:y.started_at&&y.finished_at?Di(Date.parse(y.finished_at)-Date.parse(y.started_at)):""})]},y.id)})})]})}),u.length>500&&v("p",{children:["The first 500 of ",Re(u.length),". ",v("a",{href:`#/jobs?batch=${n}`,children:"All of them"})]})]})}var Nc=16;function fM({name:n,values:e}){if(e.length===0)return null;let t=Math.max(...e)*1.0001||1,i=Array.from({length:Nc},()=>0);for(let o of e)i[Math.min(Nc-1,Math.floor(Nc*o/t))]++;let s=i.map((o,a)=>(a+.5)*t/Nc),r=[...e].sort((o,a)=>o-a)[Math.floor(e.length/2)];return v("section",{class:"card",children:[v("h2",{children:n}),v(zo,{title:`${n}: ${e.length} matches, median ${r.toPrecision(3)}`,x:s,series:[{label:"matches",color:"#2f7ebc",values:i}],height:170,xLabel:n,yLabel:"matches",bars:!0,marks:[{at:r,text:`median ${r.toPrecision(3)}`}]})]})}var wr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2};var k_=0,Vd=1,z_=2;var Pl=1,V_=2,da=3,Tr=0,ui=1,di=2,to=0,pa=1,Gd=2,Hd=3,Wd=4,G_=5;var no=100,H_=101,W_=102,X_=103,q_=104,$_=200,Y_=201,J_=202,j_=203,Xd=204,qd=205,Z_=206,K_=207,Q_=208,ex=209,tx=210,nx=211,ix=212,sx=213,rx=214,ou=0,au=1,lu=2,na=3,cu=4,uu=5,hu=6,fu=7,Uu=0,ox=1,ax=2,vs=0,$d=1,Yd=2,Jd=3,jd=4,Zd=5,Kd=6,Qd=7;var ep=300,io=301,ma=302,Bu=303,ku=304,du=1e3,gs=1001,pu=1002,Bn=1003,lx=1004;var Il=1005;var ci=1006,zu=1007;var Js=1008;var pi=1009,tp=1010,np=1011,ga=1012,Vu=1013,ts=1014,Vi=1015,ns=1016,Gu=1017,Hu=1018,so=1020,ip=35902,sp=35899,rp=1021,op=1022,is=1023,Gs=1026,js=1027,Wu=1028,Xu=1029,Ar=1030,qu=1031;var $u=1033,Ll=33776,Dl=33777,Nl=33778,Ol=33779,Yu=35840,Ju=35841,ju=35842,Zu=35843,Ku=36196,Qu=37492,eh=37496,th=37488,nh=37489,Fl=37490,ih=37491,sh=37808,rh=37809,oh=37810,ah=37811,lh=37812,ch=37813,uh=37814,hh=37815,fh=37816,dh=37817,ph=37818,mh=37819,gh=37820,_h=37821,xh=36492,vh=36494,yh=36495,bh=36283,Sh=36284,Ul=36285,Mh=36286;var ol=2300,mu=2301,su=2302,Id=2303,Ld=2400,Dd=2401,Nd=2402;var cx=3200;var wh=0,ux=1,Zs="",Yn="srgb",al="srgb-linear",ll="linear",Pt="srgb";var ru=7680;var hx=519,fx=512,dx=513,px=514,ap=515,mx=516,gx=517,lp=518,cp=519,_x=35044;var up="300 es",ki=2e3,ia=2001;function dM(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function pM(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function cl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function xx(){let n=cl("canvas");return n.style.display="block",n}var o_={},sa=null;function hp(...n){let e="THREE."+n.shift();sa?sa("log",e,...n):console.log(e,...n)}function vx(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ye(...n){n=vx(n);let e="THREE."+n.shift();if(sa)sa("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function et(...n){n=vx(n);let e="THREE."+n.shift();if(sa)sa("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function il(...n){let e=n.join(" ");e in o_||(o_[e]=!0,Ye(...n))}function yx(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var bx={[ou]:ou,[lu]:hu,[cu]:cu,[na]:uu,[au]:au,[hu]:lu,[fu]:fu,[uu]:na},Qi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},qn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],a_=1234567,sl=Math.PI/180,ra=180/Math.PI;function _a(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(qn[n&255]+qn[n>>8&255]+qn[n>>16&255]+qn[n>>24&255]+"-"+qn[e&255]+qn[e>>8&255]+"-"+qn[e>>16&15|64]+qn[e>>24&255]+"-"+qn[t&63|128]+qn[t>>8&255]+"-"+qn[t>>16&255]+qn[t>>24&255]+qn[i&255]+qn[i>>8&255]+qn[i>>16&255]+qn[i>>24&255]).toLowerCase()}function bt(n,e,t){return Math.max(e,Math.min(t,n))}function fp(n,e){return(n%e+e)%e}function mM(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function gM(n,e,t){return n!==e?(t-n)/(e-n):0}function rl(n,e,t){return(1-t)*n+t*e}function _M(n,e,t,i){return rl(n,e,1-Math.exp(-t*i))}function xM(n,e=1){return e-Math.abs(fp(n,e*2)-e)}function vM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function yM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function bM(n,e){return n+Math.floor(Math.random()*(e-n+1))}function SM(n,e){return n+Math.random()*(e-n)}function MM(n){return n*(.5-Math.random())}function wM(n){n!==void 0&&(a_=n);let e=a_+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function TM(n){return n*sl}function AM(n){return n*ra}function EM(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function CM(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function dp(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function RM(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),h=r((e-i)/2),f=o((e-i)/2),d=r((i-e)/2),x=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*h,l*f,a*c);break;case"YZY":n.set(l*f,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*f,a*u,a*c);break;case"XZX":n.set(a*u,l*x,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*x,a*c);break;case"ZYZ":n.set(l*x,l*d,a*u,a*c);break;default:Ye("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function pp(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Sx(n,e){if(e.constructor===Float32Array)return n;let t=pp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Mx(n,e){if(e.constructor===Float32Array)return n;let t=pp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Th={DEG2RAD:sl,RAD2DEG:ra,generateUUID:_a,clamp:bt,euclideanModulo:fp,mapLinear:mM,inverseLerp:gM,lerp:rl,damp:_M,pingpong:xM,smoothstep:vM,smootherstep:yM,randInt:bM,randFloat:SM,randFloatSpread:MM,seededRandom:wM,degToRad:TM,radToDeg:AM,isPowerOfTwo:EM,ceilPowerOfTwo:CM,floorPowerOfTwo:dp,setQuaternionFromProperEuler:RM,normalize:Mx,denormalize:Sx},Ze=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=bt(this.x,e.x,t.x),this.y=bt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=bt(this.x,e,t),this.y=bt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(bt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(bt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Sn=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],f=r[o+0],d=r[o+1],x=r[o+2],y=r[o+3];if(h!==y||l!==f||c!==d||u!==x){let p=l*f+c*d+u*x+h*y;p<0&&(f=-f,d=-d,x=-x,y=-y,p=-p);let m=1-a;if(p<.9995){let _=Math.acos(p),S=Math.sin(_);m=Math.sin(m*_)/S,a=Math.sin(a*_)/S,l=l*m+f*a,c=c*m+d*a,u=u*m+x*a,h=h*m+y*a}else{l=l*m+f*a,c=c*m+d*a,u=u*m+x*a,h=h*m+y*a;let _=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=_,c*=_,u*=_,h*=_}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],x=r[o+3];return e[t]=a*x+u*h+l*d-c*f,e[t+1]=l*x+u*f+c*h-a*d,e[t+2]=c*x+u*d+a*f-l*h,e[t+3]=u*x-a*h-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),d=l(s/2),x=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*x,this._y=c*d*h-f*u*x,this._z=c*u*x+f*d*h,this._w=c*u*h-f*d*x;break;case"YXZ":this._x=f*u*h+c*d*x,this._y=c*d*h-f*u*x,this._z=c*u*x-f*d*h,this._w=c*u*h+f*d*x;break;case"ZXY":this._x=f*u*h-c*d*x,this._y=c*d*h+f*u*x,this._z=c*u*x+f*d*h,this._w=c*u*h-f*d*x;break;case"ZYX":this._x=f*u*h-c*d*x,this._y=c*d*h+f*u*x,this._z=c*u*x-f*d*h,this._w=c*u*h+f*d*x;break;case"YZX":this._x=f*u*h+c*d*x,this._y=c*d*h+f*u*x,this._z=c*u*x-f*d*h,this._w=c*u*h-f*d*x;break;case"XZY":this._x=f*u*h-c*d*x,this._y=c*d*h-f*u*x,this._z=c*u*x+f*d*h,this._w=c*u*h+f*d*x;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=i+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>h){let d=2*Math.sqrt(1+i-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-i-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(bt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},W=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(l_.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(l_.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=bt(this.x,e.x,t.x),this.y=bt(this.y,e.y,t.y),this.z=bt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=bt(this.x,e,t),this.y=bt(this.y,e,t),this.z=bt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(bt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return ud.copy(this).projectOnVector(e),this.sub(ud)}reflect(e){return this.sub(ud.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(bt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ud=new W,l_=new Sn,tt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],d=i[5],x=i[8],y=s[0],p=s[3],m=s[6],_=s[1],S=s[4],b=s[7],M=s[2],w=s[5],g=s[8];return r[0]=o*y+a*_+l*M,r[3]=o*p+a*S+l*w,r[6]=o*m+a*b+l*g,r[1]=c*y+u*_+h*M,r[4]=c*p+u*S+h*w,r[7]=c*m+u*b+h*g,r[2]=f*y+d*_+x*M,r[5]=f*p+d*S+x*w,r[8]=f*m+d*b+x*g,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,x=t*h+i*f+s*d;if(x===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/x;return e[0]=h*y,e[1]=(s*c-u*i)*y,e[2]=(a*i-s*o)*y,e[3]=f*y,e[4]=(u*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=d*y,e[7]=(i*l-c*t)*y,e[8]=(o*t-i*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return il("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(hd.makeScale(e,t)),this}rotate(e){return il("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(hd.makeRotation(-e)),this}translate(e,t){return il("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(hd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},hd=new tt,c_=new tt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),u_=new tt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function PM(){let n={enabled:!0,workingColorSpace:al,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=Vs(s.r),s.g=Vs(s.g),s.b=Vs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=ta(s.r),s.g=ta(s.g),s.b=ta(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Zs?ll:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[al]:{primaries:e,whitePoint:i,transfer:ll,toXYZ:c_,fromXYZ:u_,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Yn},outputColorSpaceConfig:{drawingBufferColorSpace:Yn}},[Yn]:{primaries:e,whitePoint:i,transfer:Pt,toXYZ:c_,fromXYZ:u_,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Yn}}}),n}var yt=PM();function Vs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ta(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Vo,gu=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Vo===void 0&&(Vo=cl("canvas")),Vo.width=e.width,Vo.height=e.height;let s=Vo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Vo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=cl("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Vs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Vs(t[i]/255)*255):t[i]=Vs(t[i]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},IM=0,oa=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:IM++}),this.uuid=_a(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(fd(s[o].image)):r.push(fd(s[o]))}else r=fd(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function fd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?gu.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var LM=0,dd=new W,fi=class n extends Qi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=gs,s=gs,r=ci,o=Js,a=is,l=pi,c=n.DEFAULT_ANISOTROPY,u=Zs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:LM++}),this.uuid=_a(),this.name="",this.source=new oa(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ze(0,0),this.repeat=new Ze(1,1),this.center=new Ze(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new tt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(dd).x}get height(){return this.source.getSize(dd).y}get depth(){return this.source.getSize(dd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==ep)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case du:e.x=e.x-Math.floor(e.x);break;case gs:e.x=e.x<0?0:1;break;case pu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case du:e.y=e.y-Math.floor(e.y);break;case gs:e.y=e.y<0?0:1;break;case pu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};fi.DEFAULT_IMAGE=null;fi.DEFAULT_MAPPING=ep;fi.DEFAULT_ANISOTROPY=1;var kt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],x=l[9],y=l[2],p=l[6],m=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-y)<.01&&Math.abs(x-p)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+y)<.1&&Math.abs(x+p)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let S=(c+1)/2,b=(d+1)/2,M=(m+1)/2,w=(u+f)/4,g=(h+y)/4,T=(x+p)/4;return S>b&&S>M?S<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(S),s=w/i,r=g/i):b>M?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=w/s,r=T/s):M<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(M),i=g/r,s=T/r),this.set(i,s,r,t),this}let _=Math.sqrt((p-x)*(p-x)+(h-y)*(h-y)+(f-u)*(f-u));return Math.abs(_)<.001&&(_=1),this.x=(p-x)/_,this.y=(h-y)/_,this.z=(f-u)/_,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=bt(this.x,e.x,t.x),this.y=bt(this.y,e.y,t.y),this.z=bt(this.z,e.z,t.z),this.w=bt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=bt(this.x,e,t),this.y=bt(this.y,e,t),this.z=bt(this.z,e,t),this.w=bt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(bt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},_u=class extends Qi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ci,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new kt(0,0,e,t),this.scissorTest=!1,this.viewport=new kt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new fi({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ci,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new oa(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ci=class extends _u{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},ul=class extends fi{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Bn,this.minFilter=Bn,this.wrapR=gs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var xu=class extends fi{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Bn,this.minFilter=Bn,this.wrapR=gs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var mt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,f,d,x,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,f,d,x,y,p)}set(e,t,i,s,r,o,a,l,c,u,h,f,d,x,y,p){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=f,m[3]=d,m[7]=x,m[11]=y,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Go.setFromMatrixColumn(e,0).length(),r=1/Go.setFromMatrixColumn(e,1).length(),o=1/Go.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,d=o*h,x=a*u,y=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=d+x*c,t[5]=f-y*c,t[9]=-a*l,t[2]=y-f*c,t[6]=x+d*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,d=l*h,x=c*u,y=c*h;t[0]=f+y*a,t[4]=x*a-d,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=d*a-x,t[6]=y+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,d=l*h,x=c*u,y=c*h;t[0]=f-y*a,t[4]=-o*h,t[8]=x+d*a,t[1]=d+x*a,t[5]=o*u,t[9]=y-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,d=o*h,x=a*u,y=a*h;t[0]=l*u,t[4]=x*c-d,t[8]=f*c+y,t[1]=l*h,t[5]=y*c+f,t[9]=d*c-x,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,d=o*c,x=a*l,y=a*c;t[0]=l*u,t[4]=y-f*h,t[8]=x*h+d,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*h+x,t[10]=f-y*h}else if(e.order==="XZY"){let f=o*l,d=o*c,x=a*l,y=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+y,t[5]=o*u,t[9]=d*h-x,t[2]=x*h-d,t[6]=a*u,t[10]=y*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(DM,e,NM)}lookAt(e,t,i){let s=this.elements;return Ti.subVectors(e,t),Ti.lengthSq()===0&&(Ti.z=1),Ti.normalize(),dr.crossVectors(i,Ti),dr.lengthSq()===0&&(Math.abs(i.z)===1?Ti.x+=1e-4:Ti.z+=1e-4,Ti.normalize(),dr.crossVectors(i,Ti)),dr.normalize(),Oc.crossVectors(Ti,dr),s[0]=dr.x,s[4]=Oc.x,s[8]=Ti.x,s[1]=dr.y,s[5]=Oc.y,s[9]=Ti.y,s[2]=dr.z,s[6]=Oc.z,s[10]=Ti.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],d=i[13],x=i[2],y=i[6],p=i[10],m=i[14],_=i[3],S=i[7],b=i[11],M=i[15],w=s[0],g=s[4],T=s[8],L=s[12],P=s[1],D=s[5],I=s[9],U=s[13],N=s[2],G=s[6],Y=s[10],k=s[14],se=s[3],$=s[7],Z=s[11],q=s[15];return r[0]=o*w+a*P+l*N+c*se,r[4]=o*g+a*D+l*G+c*$,r[8]=o*T+a*I+l*Y+c*Z,r[12]=o*L+a*U+l*k+c*q,r[1]=u*w+h*P+f*N+d*se,r[5]=u*g+h*D+f*G+d*$,r[9]=u*T+h*I+f*Y+d*Z,r[13]=u*L+h*U+f*k+d*q,r[2]=x*w+y*P+p*N+m*se,r[6]=x*g+y*D+p*G+m*$,r[10]=x*T+y*I+p*Y+m*Z,r[14]=x*L+y*U+p*k+m*q,r[3]=_*w+S*P+b*N+M*se,r[7]=_*g+S*D+b*G+M*$,r[11]=_*T+S*I+b*Y+M*Z,r[15]=_*L+S*U+b*k+M*q,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],d=e[14],x=e[3],y=e[7],p=e[11],m=e[15],_=l*d-c*f,S=a*d-c*h,b=a*f-l*h,M=o*d-c*u,w=o*f-l*u,g=o*h-a*u;return t*(y*_-p*S+m*b)-i*(x*_-p*M+m*w)+s*(x*S-y*M+m*g)-r*(x*b-y*w+p*g)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],d=e[11],x=e[12],y=e[13],p=e[14],m=e[15],_=t*a-i*o,S=t*l-s*o,b=t*c-r*o,M=i*l-s*a,w=i*c-r*a,g=s*c-r*l,T=u*y-h*x,L=u*p-f*x,P=u*m-d*x,D=h*p-f*y,I=h*m-d*y,U=f*m-d*p,N=_*U-S*I+b*D+M*P-w*L+g*T;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/N;return e[0]=(a*U-l*I+c*D)*G,e[1]=(s*I-i*U-r*D)*G,e[2]=(y*g-p*w+m*M)*G,e[3]=(f*w-h*g-d*M)*G,e[4]=(l*P-o*U-c*L)*G,e[5]=(t*U-s*P+r*L)*G,e[6]=(p*b-x*g-m*S)*G,e[7]=(u*g-f*b+d*S)*G,e[8]=(o*I-a*P+c*T)*G,e[9]=(i*P-t*I-r*T)*G,e[10]=(x*w-y*b+m*_)*G,e[11]=(h*b-u*w-d*_)*G,e[12]=(a*L-o*D-l*T)*G,e[13]=(t*D-i*L+s*T)*G,e[14]=(y*S-x*M-p*_)*G,e[15]=(u*M-h*S+f*_)*G,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,x=r*h,y=o*u,p=o*h,m=a*h,_=l*c,S=l*u,b=l*h,M=i.x,w=i.y,g=i.z;return s[0]=(1-(y+m))*M,s[1]=(d+b)*M,s[2]=(x-S)*M,s[3]=0,s[4]=(d-b)*w,s[5]=(1-(f+m))*w,s[6]=(p+_)*w,s[7]=0,s[8]=(x+S)*g,s[9]=(p-_)*g,s[10]=(1-(f+y))*g,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Go.set(s[0],s[1],s[2]).length(),a=Go.set(s[4],s[5],s[6]).length(),l=Go.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ji.copy(this);let c=1/o,u=1/a,h=1/l;return Ji.elements[0]*=c,Ji.elements[1]*=c,Ji.elements[2]*=c,Ji.elements[4]*=u,Ji.elements[5]*=u,Ji.elements[6]*=u,Ji.elements[8]*=h,Ji.elements[9]*=h,Ji.elements[10]*=h,t.setFromRotationMatrix(Ji),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=ki,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),f=(t+e)/(t-e),d=(i+s)/(i-s),x,y;if(l)x=r/(o-r),y=o*r/(o-r);else if(a===ki)x=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===ia)x=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=x,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=ki,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),f=-(t+e)/(t-e),d=-(i+s)/(i-s),x,y;if(l)x=1/(o-r),y=o/(o-r);else if(a===ki)x=-2/(o-r),y=-(o+r)/(o-r);else if(a===ia)x=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=x,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Go=new W,Ji=new mt,DM=new W(0,0,0),NM=new W(1,1,1),dr=new W,Oc=new W,Ti=new W,h_=new mt,f_=new Sn,Hs=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(bt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-bt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(bt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-bt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(bt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-bt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return h_.makeRotationFromQuaternion(e),this.setFromRotationMatrix(h_,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return f_.setFromEuler(this),this.setFromQuaternion(f_,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Hs.DEFAULT_ORDER="XYZ";var aa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},OM=0,d_=new W,Ho=new Sn,Os=new mt,Fc=new W,ja=new W,FM=new W,UM=new Sn,p_=new W(1,0,0),m_=new W(0,1,0),g_=new W(0,0,1),__={type:"added"},BM={type:"removed"},Wo={type:"childadded",child:null},pd={type:"childremoved",child:null},Vn=class n extends Qi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:OM++}),this.uuid=_a(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new W,t=new Hs,i=new Sn,s=new W(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new mt},normalMatrix:{value:new tt}}),this.matrix=new mt,this.matrixWorld=new mt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new aa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Ho.setFromAxisAngle(e,t),this.quaternion.multiply(Ho),this}rotateOnWorldAxis(e,t){return Ho.setFromAxisAngle(e,t),this.quaternion.premultiply(Ho),this}rotateX(e){return this.rotateOnAxis(p_,e)}rotateY(e){return this.rotateOnAxis(m_,e)}rotateZ(e){return this.rotateOnAxis(g_,e)}translateOnAxis(e,t){return d_.copy(e).applyQuaternion(this.quaternion),this.position.add(d_.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(p_,e)}translateY(e){return this.translateOnAxis(m_,e)}translateZ(e){return this.translateOnAxis(g_,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Os.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Fc.copy(e):Fc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ja.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Os.lookAt(ja,Fc,this.up):Os.lookAt(Fc,ja,this.up),this.quaternion.setFromRotationMatrix(Os),s&&(Os.extractRotation(s.matrixWorld),Ho.setFromRotationMatrix(Os),this.quaternion.premultiply(Ho.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(et("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(__),Wo.child=e,this.dispatchEvent(Wo),Wo.child=null):et("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(BM),pd.child=e,this.dispatchEvent(pd),pd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Os.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Os.multiply(e.parent.matrixWorld)),e.applyMatrix4(Os),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(__),Wo.child=e,this.dispatchEvent(Wo),Wo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ja,e,FM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ja,UM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),d=o(e.animations),x=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),x.length>0&&(i.nodes=x)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Vn.DEFAULT_UP=new W(0,1,0);Vn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Vn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var _s=class extends Vn{constructor(){super(),this.isGroup=!0,this.type="Group"}},kM={type:"move"},la=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new _s,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new _s,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new W,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new W),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new _s,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new W,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new W,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let p=t.getJointPose(y,i),m=this._getHandJoint(c,y);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,x=.005;c.inputState.pinching&&f>d+x?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-x&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(kM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new _s;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},wx={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},pr={h:0,s:0,l:0},Uc={h:0,s:0,l:0};function md(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var it=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Yn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,yt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=yt.workingColorSpace){return this.r=e,this.g=t,this.b=i,yt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=yt.workingColorSpace){if(e=fp(e,1),t=bt(t,0,1),i=bt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=md(o,r,e+1/3),this.g=md(o,r,e),this.b=md(o,r,e-1/3)}return yt.colorSpaceToWorking(this,s),this}setStyle(e,t=Yn){function i(r){r!==void 0&&parseFloat(r)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Yn){let i=wx[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Vs(e.r),this.g=Vs(e.g),this.b=Vs(e.b),this}copyLinearToSRGB(e){return this.r=ta(e.r),this.g=ta(e.g),this.b=ta(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Yn){return yt.workingToColorSpace($n.copy(this),e),Math.round(bt($n.r*255,0,255))*65536+Math.round(bt($n.g*255,0,255))*256+Math.round(bt($n.b*255,0,255))}getHexString(e=Yn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=yt.workingColorSpace){yt.workingToColorSpace($n.copy(this),t);let i=$n.r,s=$n.g,r=$n.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=yt.workingColorSpace){return yt.workingToColorSpace($n.copy(this),t),e.r=$n.r,e.g=$n.g,e.b=$n.b,e}getStyle(e=Yn){yt.workingToColorSpace($n.copy(this),e);let t=$n.r,i=$n.g,s=$n.b;return e!==Yn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(pr),this.setHSL(pr.h+e,pr.s+t,pr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(pr),e.getHSL(Uc);let i=rl(pr.h,Uc.h,t),s=rl(pr.s,Uc.s,t),r=rl(pr.l,Uc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},$n=new it;it.NAMES=wx;var es=class extends Vn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Hs,this.environmentIntensity=1,this.environmentRotation=new Hs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},ji=new W,Fs=new W,gd=new W,Us=new W,Xo=new W,qo=new W,x_=new W,_d=new W,xd=new W,vd=new W,yd=new kt,bd=new kt,Sd=new kt,xr=class n{constructor(e=new W,t=new W,i=new W){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),ji.subVectors(e,t),s.cross(ji);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){ji.subVectors(s,t),Fs.subVectors(i,t),gd.subVectors(e,t);let o=ji.dot(ji),a=ji.dot(Fs),l=ji.dot(gd),c=Fs.dot(Fs),u=Fs.dot(gd),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,x=(o*u-a*l)*f;return r.set(1-d-x,x,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Us)===null?!1:Us.x>=0&&Us.y>=0&&Us.x+Us.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Us)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Us.x),l.addScaledVector(o,Us.y),l.addScaledVector(a,Us.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return yd.setScalar(0),bd.setScalar(0),Sd.setScalar(0),yd.fromBufferAttribute(e,t),bd.fromBufferAttribute(e,i),Sd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(yd,r.x),o.addScaledVector(bd,r.y),o.addScaledVector(Sd,r.z),o}static isFrontFacing(e,t,i,s){return ji.subVectors(i,t),Fs.subVectors(e,t),ji.cross(Fs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ji.subVectors(this.c,this.b),Fs.subVectors(this.a,this.b),ji.cross(Fs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Xo.subVectors(s,i),qo.subVectors(r,i),_d.subVectors(e,i);let l=Xo.dot(_d),c=qo.dot(_d);if(l<=0&&c<=0)return t.copy(i);xd.subVectors(e,s);let u=Xo.dot(xd),h=qo.dot(xd);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Xo,o);vd.subVectors(e,r);let d=Xo.dot(vd),x=qo.dot(vd);if(x>=0&&d<=x)return t.copy(r);let y=d*c-l*x;if(y<=0&&c>=0&&x<=0)return a=c/(c-x),t.copy(i).addScaledVector(qo,a);let p=u*x-d*h;if(p<=0&&h-u>=0&&d-x>=0)return x_.subVectors(r,s),a=(h-u)/(h-u+(d-x)),t.copy(s).addScaledVector(x_,a);let m=1/(p+y+f);return o=y*m,a=f*m,t.copy(i).addScaledVector(Xo,o).addScaledVector(qo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},xs=class{constructor(e=new W(1/0,1/0,1/0),t=new W(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Zi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Zi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Zi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Zi):Zi.fromBufferAttribute(r,o),Zi.applyMatrix4(e.matrixWorld),this.expandByPoint(Zi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Bc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Bc.copy(i.boundingBox)),Bc.applyMatrix4(e.matrixWorld),this.union(Bc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Zi),Zi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Za),kc.subVectors(this.max,Za),$o.subVectors(e.a,Za),Yo.subVectors(e.b,Za),Jo.subVectors(e.c,Za),mr.subVectors(Yo,$o),gr.subVectors(Jo,Yo),$r.subVectors($o,Jo);let t=[0,-mr.z,mr.y,0,-gr.z,gr.y,0,-$r.z,$r.y,mr.z,0,-mr.x,gr.z,0,-gr.x,$r.z,0,-$r.x,-mr.y,mr.x,0,-gr.y,gr.x,0,-$r.y,$r.x,0];return!Md(t,$o,Yo,Jo,kc)||(t=[1,0,0,0,1,0,0,0,1],!Md(t,$o,Yo,Jo,kc))?!1:(zc.crossVectors(mr,gr),t=[zc.x,zc.y,zc.z],Md(t,$o,Yo,Jo,kc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Zi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Zi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Bs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Bs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Bs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Bs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Bs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Bs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Bs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Bs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Bs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Bs=[new W,new W,new W,new W,new W,new W,new W,new W],Zi=new W,Bc=new xs,$o=new W,Yo=new W,Jo=new W,mr=new W,gr=new W,$r=new W,Za=new W,kc=new W,zc=new W,Yr=new W;function Md(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Yr.fromArray(n,r);let a=s.x*Math.abs(Yr.x)+s.y*Math.abs(Yr.y)+s.z*Math.abs(Yr.z),l=e.dot(Yr),c=t.dot(Yr),u=i.dot(Yr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var bn=new W,Vc=new Ze,zM=0,Ft=class extends Qi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:zM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=_x,this.updateRanges=[],this.gpuType=Vi,this.version=0,this._normalizationScale=e!==void 0?pp(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Vc.fromBufferAttribute(this,t),Vc.applyMatrix3(e),this.setXY(t,Vc.x,Vc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)bn.fromBufferAttribute(this,t),bn.applyMatrix3(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)bn.fromBufferAttribute(this,t),bn.applyMatrix4(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)bn.fromBufferAttribute(this,t),bn.applyNormalMatrix(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)bn.fromBufferAttribute(this,t),bn.transformDirection(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Sx(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Mx(e,this.array)}},hl=class extends Ft{constructor(e,t,i){super(new Int8Array(e),t,i)}},fl=class extends Ft{constructor(e,t,i){super(new Uint8Array(e),t,i)}};var dl=class extends Ft{constructor(e,t,i){super(new Int16Array(e),t,i)}},Zr=class extends Ft{constructor(e,t,i){super(new Uint16Array(e),t,i)}},pl=class extends Ft{constructor(e,t,i){super(new Int32Array(e),t,i)}},Kr=class extends Ft{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Cn=class extends Ft{constructor(e,t,i){super(new Float32Array(e),t,i)}},VM=new xs,Ka=new W,wd=new W,Ws=class{constructor(e=new W,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):VM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ka.subVectors(e,this.center);let t=Ka.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Ka,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(wd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ka.copy(e.center).add(wd)),this.expandByPoint(Ka.copy(e.center).sub(wd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},GM=0,Bi=new mt,Td=new Vn,jo=new W,Ai=new xs,Qa=new xs,Un=new W,Jn=class n extends Qi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:GM++}),this.uuid=_a(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(dM(e)?Kr:Zr)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new tt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Bi.makeRotationFromQuaternion(e),this.applyMatrix4(Bi),this}rotateX(e){return Bi.makeRotationX(e),this.applyMatrix4(Bi),this}rotateY(e){return Bi.makeRotationY(e),this.applyMatrix4(Bi),this}rotateZ(e){return Bi.makeRotationZ(e),this.applyMatrix4(Bi),this}translate(e,t,i){return Bi.makeTranslation(e,t,i),this.applyMatrix4(Bi),this}scale(e,t,i){return Bi.makeScale(e,t,i),this.applyMatrix4(Bi),this}lookAt(e){return Td.lookAt(e),Td.updateMatrix(),this.applyMatrix4(Td.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(jo).negate(),this.translate(jo.x,jo.y,jo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Cn(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new xs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new W(-1/0,-1/0,-1/0),new W(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];Ai.setFromBufferAttribute(r),this.morphTargetsRelative?(Un.addVectors(this.boundingBox.min,Ai.min),this.boundingBox.expandByPoint(Un),Un.addVectors(this.boundingBox.max,Ai.max),this.boundingBox.expandByPoint(Un)):(this.boundingBox.expandByPoint(Ai.min),this.boundingBox.expandByPoint(Ai.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&et('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ws);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new W,1/0);return}if(e){let i=this.boundingSphere.center;if(Ai.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Qa.setFromBufferAttribute(a),this.morphTargetsRelative?(Un.addVectors(Ai.min,Qa.min),Ai.expandByPoint(Un),Un.addVectors(Ai.max,Qa.max),Ai.expandByPoint(Un)):(Ai.expandByPoint(Qa.min),Ai.expandByPoint(Qa.max))}Ai.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Un.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Un));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Un.fromBufferAttribute(a,c),l&&(jo.fromBufferAttribute(e,c),Un.add(jo)),s=Math.max(s,i.distanceToSquared(Un))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&et('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){et("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Ft(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let L=0;L<i.count;L++)a[L]=new W,l[L]=new W;let u=new W,h=new W,f=new W,d=new Ze,x=new Ze,y=new Ze,p=new W,m=new W;function _(L,P,D){c[L]=c[P]=c[D]=1,u.fromBufferAttribute(i,L),h.fromBufferAttribute(i,P),f.fromBufferAttribute(i,D),d.fromBufferAttribute(r,L),x.fromBufferAttribute(r,P),y.fromBufferAttribute(r,D),h.sub(u),f.sub(u),x.sub(d),y.sub(d);let I=1/(x.x*y.y-y.x*x.y);isFinite(I)&&(p.copy(h).multiplyScalar(y.y).addScaledVector(f,-x.y).multiplyScalar(I),m.copy(f).multiplyScalar(x.x).addScaledVector(h,-y.x).multiplyScalar(I),a[L].add(p),a[P].add(p),a[D].add(p),l[L].add(m),l[P].add(m),l[D].add(m))}let S=this.groups;S.length===0&&(S=[{start:0,count:e.count}]);for(let L=0,P=S.length;L<P;++L){let D=S[L],I=D.start,U=D.count;for(let N=I,G=I+U;N<G;N+=3)_(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let b=new W,M=new W,w=new W,g=new W;function T(L){w.fromBufferAttribute(s,L),g.copy(w);let P=a[L];b.copy(P),b.sub(w.multiplyScalar(w.dot(P))).normalize(),M.crossVectors(g,P);let I=M.dot(l[L])<0?-1:1;o.setXYZW(L,b.x,b.y,b.z,I)}for(let L=0,P=i.count;L<P;++L)c[L]&&T(L);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Ft(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let s=new W,r=new W,o=new W,a=new W,l=new W,c=new W,u=new W,h=new W;if(e)for(let f=0,d=e.count;f<d;f+=3){let x=e.getX(f+0),y=e.getX(f+1),p=e.getX(f+2);s.fromBufferAttribute(t,x),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,p),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,x),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,p),a.add(u),l.add(u),c.add(u),i.setXYZ(x,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Un.fromBufferAttribute(e,t),Un.normalize(),e.setXYZ(t,Un.x,Un.y,Un.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,x=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*u;for(let m=0;m<u;m++)f[x++]=c[d++]}return new Ft(f,u,h)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=e(f,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Ad=new W,HM=new W,WM=new tt,Ki=class{constructor(e=new W(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Ad.subVectors(i,t).cross(HM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Ad),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||WM.getNormalMatrix(e),s=this.coplanarPoint(Ad).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},XM=0,Xs=class extends Qi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:XM++}),this.uuid=_a(),this.name="",this.type="Material",this.blending=pa,this.side=Tr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Xd,this.blendDst=qd,this.blendEquation=no,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new it(0,0,0),this.blendAlpha=0,this.depthFunc=na,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=hx,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ru,this.stencilZFail=ru,this.stencilZPass=ru,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new it().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Ki().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ze().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ze().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ks=new W,Ed=new W,Gc=new W,Hc=new W,ca=class{constructor(e=new W,t=new W(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ks)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ks.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ks.copy(this.origin).addScaledVector(this.direction,t),ks.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Ed.copy(e).add(t).multiplyScalar(.5),Gc.copy(t).sub(e).normalize(),Hc.copy(this.origin).sub(Ed);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Gc),a=Hc.dot(this.direction),l=-Hc.dot(Gc),c=Hc.lengthSq(),u=Math.abs(1-o*o),h,f,d,x;if(u>0)if(h=o*l-a,f=o*a-l,x=r*u,h>=0)if(f>=-x)if(f<=x){let y=1/u;h*=y,f*=y,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-x?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=x?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Ed).addScaledVector(Gc,f),d}intersectSphere(e,t){if(e.radius<0)return null;ks.subVectors(e.center,this.origin);let i=ks.dot(this.direction),s=ks.dot(ks)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,ks)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,f=e.y-o.y,d=e.z-o.z,x=t.x-o.x,y=t.y-o.y,p=t.z-o.z,m=i.x-o.x,_=i.y-o.y,S=i.z-o.z,b=Math.abs(l),M=Math.abs(c),w=Math.abs(u),g,T,L,P,D,I,U,N,G,Y,k,se;if(b>=M&&b>=w?(L=l,I=h,G=x,se=m,l>=0?(g=c,T=u,P=f,D=d,U=y,N=p,Y=_,k=S):(g=u,T=c,P=d,D=f,U=p,N=y,Y=S,k=_)):M>=w?(L=c,I=f,G=y,se=_,c>=0?(g=u,T=l,P=d,D=h,U=p,N=x,Y=S,k=m):(g=l,T=u,P=h,D=d,U=x,N=p,Y=m,k=S)):(L=u,I=d,G=p,se=S,u>=0?(g=l,T=c,P=h,D=f,U=x,N=y,Y=m,k=_):(g=c,T=l,P=f,D=h,U=y,N=x,Y=_,k=m)),L===0)return null;let $=g/L,Z=T/L,q=1/L,ie=P-$*I,ne=D-Z*I,K=U-$*G,he=N-Z*G,me=Y-$*se,xe=k-Z*se,ve=me*he-xe*K,He=ie*xe-ne*me,ot=K*ne-he*ie;if(s){if(ve<0||He<0||ot<0)return null}else if((ve<0||He<0||ot<0)&&(ve>0||He>0||ot>0))return null;let We=ve+He+ot;if(We===0)return null;let ft=q*(ve*I+He*G+ot*se);return(We>0?ft<0:ft>0)?null:this.at(ft/We,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},qs=class extends Xs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new it(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Hs,this.combine=Uu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},v_=new mt,Jr=new ca,Wc=new Ws,y_=new W,Xc=new W,qc=new W,$c=new W,Cd=new W,Yc=new W,b_=new W,Jc=new W,Mn=class extends Vn{constructor(e=new Jn,t=new qs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Yc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Cd.fromBufferAttribute(h,e),o?Yc.addScaledVector(Cd,u):Yc.addScaledVector(Cd.sub(t),u))}t.add(Yc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Wc.copy(i.boundingSphere),Wc.applyMatrix4(r),Jr.copy(e.ray).recast(e.near),!(Wc.containsPoint(Jr.origin)===!1&&(Jr.intersectSphere(Wc,y_)===null||Jr.origin.distanceToSquared(y_)>(e.far-e.near)**2))&&(v_.copy(r).invert(),Jr.copy(e.ray).applyMatrix4(v_),!(i.boundingBox!==null&&Jr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Jr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let x=0,y=f.length;x<y;x++){let p=f[x],m=o[p.materialIndex],_=Math.max(p.start,d.start),S=Math.min(a.count,Math.min(p.start+p.count,d.start+d.count));for(let b=_,M=S;b<M;b+=3){let w=a.getX(b),g=a.getX(b+1),T=a.getX(b+2);s=jc(this,m,e,i,c,u,h,w,g,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let x=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let p=x,m=y;p<m;p+=3){let _=a.getX(p),S=a.getX(p+1),b=a.getX(p+2);s=jc(this,o,e,i,c,u,h,_,S,b),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let x=0,y=f.length;x<y;x++){let p=f[x],m=o[p.materialIndex],_=Math.max(p.start,d.start),S=Math.min(l.count,Math.min(p.start+p.count,d.start+d.count));for(let b=_,M=S;b<M;b+=3){let w=b,g=b+1,T=b+2;s=jc(this,m,e,i,c,u,h,w,g,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let x=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let p=x,m=y;p<m;p+=3){let _=p,S=p+1,b=p+2;s=jc(this,o,e,i,c,u,h,_,S,b),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function qM(n,e,t,i,s,r,o,a){let l;if(e.side===ui?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Tr,a),l===null)return null;Jc.copy(a),Jc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Jc);return c<t.near||c>t.far?null:{distance:c,point:Jc.clone(),object:n}}function jc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Xc),n.getVertexPosition(l,qc),n.getVertexPosition(c,$c);let u=qM(n,e,t,i,Xc,qc,$c,b_);if(u){let h=new W;xr.getBarycoord(b_,Xc,qc,$c,h),s&&(u.uv=xr.getInterpolatedAttribute(s,a,l,c,h,new Ze)),r&&(u.uv1=xr.getInterpolatedAttribute(r,a,l,c,h,new Ze)),o&&(u.normal=xr.getInterpolatedAttribute(o,a,l,c,h,new W),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new W,materialIndex:0};xr.getNormal(Xc,qc,$c,f.normal),u.face=f,u.barycoord=h}return u}var $s=class extends fi{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Bn,u=Bn,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ml=class extends Ft{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Zo=new mt,S_=new mt,Zc=[],M_=new xs,$M=new mt,el=new Mn,tl=new Ws,gl=class extends Mn{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new ml(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,$M)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new xs),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Zo),M_.copy(e.boundingBox).applyMatrix4(Zo),this.boundingBox.union(M_)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Ws),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Zo),tl.copy(e.boundingSphere).applyMatrix4(Zo),this.boundingSphere.union(tl)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(el.geometry=this.geometry,el.material=this.material,el.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),tl.copy(this.boundingSphere),tl.applyMatrix4(i),e.ray.intersectsSphere(tl)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Zo),S_.multiplyMatrices(i,Zo),el.matrixWorld=S_,el.raycast(e,Zc);for(let o=0,a=Zc.length;o<a;o++){let l=Zc[o];l.instanceId=r,l.object=this,t.push(l)}Zc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new ml(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new $s(new Float32Array(s*this.count),s,this.count,Wu,Vi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},jr=new Ws,YM=new Ze(.5,.5),Kc=new W,vr=class{constructor(e=new Ki,t=new Ki,i=new Ki,s=new Ki,r=new Ki,o=new Ki){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=ki,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],d=r[7],x=r[8],y=r[9],p=r[10],m=r[11],_=r[12],S=r[13],b=r[14],M=r[15];if(s[0].setComponents(c-o,d-u,m-x,M-_).normalize(),s[1].setComponents(c+o,d+u,m+x,M+_).normalize(),s[2].setComponents(c+a,d+h,m+y,M+S).normalize(),s[3].setComponents(c-a,d-h,m-y,M-S).normalize(),i)s[4].setComponents(l,f,p,b).normalize(),s[5].setComponents(c-l,d-f,m-p,M-b).normalize();else if(s[4].setComponents(c-l,d-f,m-p,M-b).normalize(),t===ki)s[5].setComponents(c+l,d+f,m+p,M+b).normalize();else if(t===ia)s[5].setComponents(l,f,p,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),jr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),jr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(jr)}intersectsSprite(e){jr.center.set(0,0,0);let t=YM.distanceTo(e.center);return jr.radius=.7071067811865476+t,jr.applyMatrix4(e.matrixWorld),this.intersectsSphere(jr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Kc.x=s.normal.x>0?e.max.x:e.min.x,Kc.y=s.normal.y>0?e.max.y:e.min.y,Kc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Kc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},w_=new mt,vu=class n{constructor(){this.coordinateSystem=ki,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];w_.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new vr),i[s].setFromProjectionMatrix(w_,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new vr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var ua=class extends Xs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new it(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},yu=new W,bu=new W,T_=new mt,nl=new ca,Qc=new Ws,Rd=new W,A_=new W,Su=class extends Vn{constructor(e=new Jn,t=new ua){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)yu.fromBufferAttribute(t,s-1),bu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=yu.distanceTo(bu);e.setAttribute("lineDistance",new Cn(i,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Qc.copy(i.boundingSphere),Qc.applyMatrix4(s),Qc.radius+=r,e.ray.intersectsSphere(Qc)===!1)return;T_.copy(s).invert(),nl.copy(e.ray).applyMatrix4(T_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),x=Math.min(u.count,o.start+o.count);for(let y=d,p=x-1;y<p;y+=c){let m=u.getX(y),_=u.getX(y+1),S=eu(this,e,nl,l,m,_,y);S&&t.push(S)}if(this.isLineLoop){let y=u.getX(x-1),p=u.getX(d),m=eu(this,e,nl,l,y,p,x-1);m&&t.push(m)}}else{let d=Math.max(0,o.start),x=Math.min(f.count,o.start+o.count);for(let y=d,p=x-1;y<p;y+=c){let m=eu(this,e,nl,l,y,y+1,y);m&&t.push(m)}if(this.isLineLoop){let y=eu(this,e,nl,l,x-1,d,x-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function eu(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(yu.fromBufferAttribute(a,s),bu.fromBufferAttribute(a,r),t.distanceSqToSegment(yu,bu,Rd,A_)>i)return;Rd.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Rd);if(!(c<e.near||c>e.far))return{distance:c,point:A_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var E_=new W,C_=new W,_l=class extends Su{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)E_.fromBufferAttribute(t,s),C_.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+E_.distanceTo(C_);e.setAttribute("lineDistance",new Cn(i,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var xl=class extends fi{constructor(e=[],t=io,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ys=class extends fi{constructor(e,t,i=ts,s,r,o,a=Bn,l=Bn,c,u=Gs,h=1){if(u!==Gs&&u!==js)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new oa(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},vl=class extends Ys{constructor(e,t=ts,i=io,s,r,o=Bn,a=Bn,l,c=Gs){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},yl=class extends fi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ha=class n extends Jn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;x("z","y","x",-1,-1,i,t,e,o,r,0),x("z","y","x",1,-1,i,t,-e,o,r,1),x("x","z","y",1,1,e,i,t,s,o,2),x("x","z","y",1,-1,e,i,-t,s,o,3),x("x","y","z",1,-1,e,t,i,s,r,4),x("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Cn(c,3)),this.setAttribute("normal",new Cn(u,3)),this.setAttribute("uv",new Cn(h,2));function x(y,p,m,_,S,b,M,w,g,T,L){let P=b/g,D=M/T,I=b/2,U=M/2,N=w/2,G=g+1,Y=T+1,k=0,se=0,$=new W;for(let Z=0;Z<Y;Z++){let q=Z*D-U;for(let ie=0;ie<G;ie++){let ne=ie*P-I;$[y]=ne*_,$[p]=q*S,$[m]=N,c.push($.x,$.y,$.z),$[y]=0,$[p]=0,$[m]=w>0?1:-1,u.push($.x,$.y,$.z),h.push(ie/g),h.push(1-Z/T),k+=1}}for(let Z=0;Z<T;Z++)for(let q=0;q<g;q++){let ie=f+q+G*Z,ne=f+q+G*(Z+1),K=f+(q+1)+G*(Z+1),he=f+(q+1)+G*Z;l.push(ie,ne,he),l.push(ne,K,he),se+=6}a.addGroup(d,se,L),d+=se,f+=k}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var bl=class n extends Jn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,d=[],x=[],y=[],p=[];for(let m=0;m<u;m++){let _=m*f-o;for(let S=0;S<c;S++){let b=S*h-r;x.push(b,-_,0),y.push(0,0,1),p.push(S/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let _=0;_<a;_++){let S=_+c*m,b=_+c*(m+1),M=_+1+c*(m+1),w=_+1+c*m;d.push(S,b,w),d.push(b,M,w)}this.setIndex(d),this.setAttribute("position",new Cn(x,3)),this.setAttribute("normal",new Cn(y,3)),this.setAttribute("uv",new Cn(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var yr=class n extends Jn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new W,f=new W,d=[],x=[],y=[],p=[];for(let m=0;m<=i;m++){let _=[],S=m/i,b=o+S*a,M=e*Math.cos(b),w=Math.sqrt(e*e-M*M),g=0;m===0&&o===0?g=.5/t:m===i&&l===Math.PI&&(g=-.5/t);for(let T=0;T<=t;T++){let L=T/t,P=s+L*r;h.x=-w*Math.cos(P),h.y=M,h.z=w*Math.sin(P),x.push(h.x,h.y,h.z),f.copy(h).normalize(),y.push(f.x,f.y,f.z),p.push(L+g,1-S),_.push(c++)}u.push(_)}for(let m=0;m<i;m++)for(let _=0;_<t;_++){let S=u[m][_+1],b=u[m][_],M=u[m+1][_],w=u[m+1][_+1];(m!==0||o>0)&&d.push(S,b,w),(m!==i-1||l<Math.PI)&&d.push(b,M,w)}this.setIndex(d),this.setAttribute("position",new Cn(x,3)),this.setAttribute("normal",new Cn(y,3)),this.setAttribute("uv",new Cn(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function ro(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(R_(s))s.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(R_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function jn(n){let e={};for(let t=0;t<n.length;t++){let i=ro(n[t]);for(let s in i)e[s]=i[s]}return e}function R_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function JM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function mp(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:yt.workingColorSpace}var Tx={clone:ro,merge:jn},jM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,ZM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,zi=class extends Xs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=jM,this.fragmentShader=ZM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=ro(e.uniforms),this.uniformsGroups=JM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new it().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ze().fromArray(s.value);break;case"v3":this.uniforms[i].value=new W().fromArray(s.value);break;case"v4":this.uniforms[i].value=new kt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new tt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new mt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Mu=class extends zi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Sl=class extends Xs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new it(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new it(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=wh,this.normalScale=new Ze(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Hs,this.combine=Uu,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},wu=class extends Xs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=cx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Tu=class extends Xs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ko(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function tu(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var br=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Au=class extends br{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ld,endingEnd:Ld}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Dd:r=e,a=2*t-i;break;case Nd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Dd:o=e,l=2*i-t;break;case Nd:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,x=(i-t)/(s-t),y=x*x,p=y*x,m=-f*p+2*f*y-f*x,_=(1+f)*p+(-1.5-2*f)*y+(-.5+f)*x+1,S=(-1-d)*p+(1.5+d)*y+.5*x,b=d*p-d*y;for(let M=0;M!==a;++M)r[M]=m*o[u+M]+_*o[c+M]+S*o[l+M]+b*o[h+M];return r}},Eu=class extends br{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},Cu=class extends br{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Ru=class extends br{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let x=(i-t)/(s-t),y=1-x;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*x;return r}let f=a*2,d=e-1;for(let x=0;x!==a;++x){let y=o[c+x],p=o[l+x],m=d*f+x*2,_=h[m],S=h[m+1],b=e*f+x*2,M=u[b],w=u[b+1],g=QM(i,t,_,M,s);r[x]=Ax(g,y,S,w,p)}return r}};function Ax(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function KM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function QM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=Ax(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=KM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Ri=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ko(t,this.TimeBufferType),this.values=Ko(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Ko(e.times,Array),values:Ko(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),tu(e.settings)&&(i.settings={inTangents:Ko(e.settings.inTangents,Array),outTangents:Ko(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Cu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Eu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Au(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Ru(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ol:t=this.InterpolantFactoryMethodDiscrete;break;case mu:t=this.InterpolantFactoryMethodLinear;break;case su:t=this.InterpolantFactoryMethodSmooth;break;case Id:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ye("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ol;case this.InterpolantFactoryMethodLinear:return mu;case this.InterpolantFactoryMethodSmooth:return su;case this.InterpolantFactoryMethodBezier:return Id}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;tu(this.settings)&&(P_(this.settings.inTangents,e),P_(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;tu(this.settings)&&(I_(this.settings.inTangents,e),I_(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(et("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(et("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){et("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){et("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&pM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){et("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===su,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,f=h-i,d=h+i;for(let x=0;x!==i;++x){let y=t[h+x];if(y!==t[f+x]||y!==t[d+x]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,f=o*i;for(let d=0;d!==i;++d)t[f+d]=t[h+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,tu(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function P_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function I_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Ri.prototype.ValueTypeName="";Ri.prototype.TimeBufferType=Float32Array;Ri.prototype.ValueBufferType=Float32Array;Ri.prototype.DefaultInterpolation=mu;var Sr=class extends Ri{constructor(e,t,i){super(e,t,i)}};Sr.prototype.ValueTypeName="bool";Sr.prototype.ValueBufferType=Array;Sr.prototype.DefaultInterpolation=ol;Sr.prototype.InterpolantFactoryMethodLinear=void 0;Sr.prototype.InterpolantFactoryMethodSmooth=void 0;var Pu=class extends Ri{constructor(e,t,i,s){super(e,t,i,s)}};Pu.prototype.ValueTypeName="color";var Iu=class extends Ri{constructor(e,t,i,s){super(e,t,i,s)}};Iu.prototype.ValueTypeName="number";var Lu=class extends br{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Sn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ml=class extends Ri{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Lu(this.times,this.values,this.getValueSize(),e)}};Ml.prototype.ValueTypeName="quaternion";Ml.prototype.InterpolantFactoryMethodSmooth=void 0;var Mr=class extends Ri{constructor(e,t,i){super(e,t,i)}};Mr.prototype.ValueTypeName="string";Mr.prototype.ValueBufferType=Array;Mr.prototype.DefaultInterpolation=ol;Mr.prototype.InterpolantFactoryMethodLinear=void 0;Mr.prototype.InterpolantFactoryMethodSmooth=void 0;var Du=class extends Ri{constructor(e,t,i,s){super(e,t,i,s)}};Du.prototype.ValueTypeName="vector";var Od={enabled:!1,files:{},add:function(n,e){this.enabled!==!1&&(L_(n)||(this.files[n]=e))},get:function(n){if(this.enabled!==!1&&!L_(n))return this.files[n]},remove:function(n){delete this.files[n]},clear:function(){this.files={}}};function L_(n){try{let e=n.slice(n.indexOf(":")+1);return new URL(e).protocol==="blob:"}catch{return!1}}var Nu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],x=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return x}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ex=new Nu,Qr=class{constructor(e){this.manager=e!==void 0?e:Ex,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Qr.DEFAULT_MATERIAL_NAME="__DEFAULT";var zs={},Fd=class extends Error{constructor(e,t){super(e),this.response=t}},wl=class extends Qr{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,i,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=Od.get(`file:${e}`);if(r!==void 0){this.manager.itemStart(e),setTimeout(()=>{t&&t(r),this.manager.itemEnd(e)},0);return}if(zs[e]!==void 0){zs[e].push({onLoad:t,onProgress:i,onError:s});return}zs[e]=[],zs[e].push({onLoad:t,onProgress:i,onError:s});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,l=this.responseType;fetch(o).then(c=>{if(c.status===200||c.status===0){if(c.status===0&&Ye("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||c.body===void 0||c.body.getReader===void 0)return c;let u=zs[e],h=c.body.getReader(),f=c.headers.get("X-File-Size")||c.headers.get("Content-Length"),d=f?parseInt(f):0,x=d!==0,y=0,p=new ReadableStream({start(m){_();function _(){h.read().then(({done:S,value:b})=>{if(S)m.close();else{y+=b.byteLength;let M=new ProgressEvent("progress",{lengthComputable:x,loaded:y,total:d});for(let w=0,g=u.length;w<g;w++){let T=u[w];T.onProgress&&T.onProgress(M)}m.enqueue(b),_()}},S=>{m.error(S)})}}});return new Response(p)}else throw new Fd(`fetch for "${c.url}" responded with ${c.status}: ${c.statusText}`,c)}).then(c=>{switch(l){case"arraybuffer":return c.arrayBuffer();case"blob":return c.blob();case"document":return c.text().then(u=>new DOMParser().parseFromString(u,a));case"json":return c.json();default:if(a==="")return c.text();{let h=/charset="?([^;"\s]*)"?/i.exec(a),f=h&&h[1]?h[1].toLowerCase():void 0,d=new TextDecoder(f);return c.arrayBuffer().then(x=>d.decode(x))}}}).then(c=>{Od.add(`file:${e}`,c);let u=zs[e];delete zs[e];for(let h=0,f=u.length;h<f;h++){let d=u[h];d.onLoad&&d.onLoad(c)}}).catch(c=>{let u=zs[e];if(u===void 0)throw this.manager.itemError(e),c;delete zs[e];for(let h=0,f=u.length;h<f;h++){let d=u[h];d.onError&&d.onError(c)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var Tl=class extends Vn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new it(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Al=class extends Tl{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Vn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new it(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Pd=new mt,D_=new W,N_=new W,Ou=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ze(512,512),this.mapType=pi,this.map=null,this.mapPass=null,this.matrix=new mt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new vr,this._frameExtents=new Ze(1,1),this._viewportCount=1,this._viewports=[new kt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;D_.setFromMatrixPosition(e.matrixWorld),t.position.copy(D_),N_.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(N_),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Pd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Pd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===ia||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Pd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},nu=new W,iu=new Sn,ms=new W,El=class extends Vn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new mt,this.projectionMatrix=new mt,this.projectionMatrixInverse=new mt,this.coordinateSystem=ki,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(nu,iu,ms),ms.x===1&&ms.y===1&&ms.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(nu,iu,ms.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(nu,iu,ms),ms.x===1&&ms.y===1&&ms.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(nu,iu,ms.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},_r=new W,O_=new Ze,F_=new Ze,Ei=class extends El{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=ra*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(sl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return ra*2*Math.atan(Math.tan(sl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){_r.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(_r.x,_r.y).multiplyScalar(-e/_r.z),_r.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(_r.x,_r.y).multiplyScalar(-e/_r.z)}getViewSize(e,t){return this.getViewBounds(e,O_,F_),t.subVectors(F_,O_)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(sl*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Pi=class extends El{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Ud=class extends Ou{constructor(){super(new Pi(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Cl=class extends Tl{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Vn.DEFAULT_UP),this.updateMatrix(),this.target=new Vn,this.shadow=new Ud}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Qo=-90,ea=1,fa=class extends Vn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Ei(Qo,ea,e,t);s.layers=this.layers,this.add(s);let r=new Ei(Qo,ea,e,t);r.layers=this.layers,this.add(r);let o=new Ei(Qo,ea,e,t);o.layers=this.layers,this.add(o);let a=new Ei(Qo,ea,e,t);a.layers=this.layers,this.add(a);let l=new Ei(Qo,ea,e,t);l.layers=this.layers,this.add(l);let c=new Ei(Qo,ea,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===ki)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===ia)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),x=e.xr.enabled;e.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=y,e.setRenderTarget(i,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,f,d),e.xr.enabled=x,i.texture.needsPMREMUpdate=!0}},Fu=class extends Ei{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var gp="\\[\\]\\.:\\/",ew=new RegExp("["+gp+"]","g"),_p="[^"+gp+"]",tw="[^"+gp.replace("\\.","")+"]",nw=/((?:WC+[\/:])*)/.source.replace("WC",_p),iw=/(WCOD+)?/.source.replace("WCOD",tw),sw=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",_p),rw=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",_p),ow=new RegExp("^"+nw+iw+sw+rw+"$"),aw=["material","materials","bones","map"],Bd=class{constructor(e,t,i){let s=i||Kt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Kt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(ew,"")}static parseTrackName(e){let t=ow.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);aw.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){et("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){et("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){et("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){et("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){et("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;et("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Kt.Composite=Bd;Kt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Kt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Kt.prototype.GetterByBindingType=[Kt.prototype._getValue_direct,Kt.prototype._getValue_array,Kt.prototype._getValue_arrayElement,Kt.prototype._getValue_toArray];Kt.prototype.SetterByBindingTypeAndVersioning=[[Kt.prototype._setValue_direct,Kt.prototype._setValue_direct_setNeedsUpdate,Kt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Kt.prototype._setValue_array,Kt.prototype._setValue_array_setNeedsUpdate,Kt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Kt.prototype._setValue_arrayElement,Kt.prototype._setValue_arrayElement_setNeedsUpdate,Kt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Kt.prototype._setValue_fromArray,Kt.prototype._setValue_fromArray_setNeedsUpdate,Kt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var A2=new Float32Array(1);var U_=new mt,eo=class{constructor(e,t,i=0,s=1/0){this.ray=new ca(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new aa,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):et("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return U_.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(U_),this}intersectObject(e,t=!0,i=[]){return kd(e,this,i,t),i.sort(B_),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)kd(e[s],this,i,t);return i.sort(B_),i}};function B_(n,e){return n.distance-e.distance}function kd(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)kd(r[o],e,t,!0)}}var zd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Rl=class extends Qi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function xp(n,e,t,i){let s=lw(i);switch(t){case rp:return n*e;case Wu:return n*e/s.components*s.byteLength;case Xu:return n*e/s.components*s.byteLength;case Ar:return n*e*2/s.components*s.byteLength;case qu:return n*e*2/s.components*s.byteLength;case op:return n*e*3/s.components*s.byteLength;case is:return n*e*4/s.components*s.byteLength;case $u:return n*e*4/s.components*s.byteLength;case Ll:case Dl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Nl:case Ol:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ju:case Zu:return Math.max(n,16)*Math.max(e,8)/4;case Yu:case ju:return Math.max(n,8)*Math.max(e,8)/2;case Ku:case Qu:case th:case nh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case eh:case Fl:case ih:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case sh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case rh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case oh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case ah:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case lh:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case ch:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case uh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case hh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case fh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case dh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case ph:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case mh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case gh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case _h:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case xh:case vh:case yh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case bh:case Sh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Ul:case Mh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function lw(n){switch(n){case pi:case tp:return{byteLength:1,components:1};case ga:case np:case ns:return{byteLength:2,components:1};case Gu:case Hu:return{byteLength:2,components:4};case ts:case Vu:case Vi:return{byteLength:4,components:1};case ip:case sp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Jx(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function uw(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((d,x)=>d.start-x.start);let f=0;for(let d=1;d<h.length;d++){let x=h[f],y=h[d];y.start<=x.start+x.count+1?x.count=Math.max(x.count,y.start+y.count-x.start):(++f,h[f]=y)}h.length=f+1;for(let d=0,x=h.length;d<x;d++){let y=h[d];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var hw=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,fw=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,dw=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,pw=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,mw=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,gw=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,_w=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,xw=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,vw=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,yw=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,bw=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Sw=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Mw=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,ww=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Tw=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Aw=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Ew=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Cw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Rw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Pw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Iw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Lw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Dw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Nw=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Ow=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Fw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Uw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Bw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,kw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,zw="gl_FragColor = linearToOutputTexel( gl_FragColor );",Vw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Gw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Hw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Ww=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Xw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,qw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,$w=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Yw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Jw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,jw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Zw=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Kw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Qw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,e1=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,t1=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,n1=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,i1=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,s1=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,r1=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,o1=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,a1=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,l1=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,c1=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,u1=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,h1=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,f1=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,d1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,p1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,m1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,g1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,_1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,x1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,v1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,y1=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,b1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,S1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,M1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,w1=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,T1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,A1=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,E1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,C1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,R1=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,P1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,I1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,L1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,D1=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,N1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,O1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,F1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,U1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,B1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,k1=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,z1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,V1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,G1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,H1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,W1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,X1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,q1=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,$1=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Y1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,J1=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,j1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Z1=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,K1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Q1=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,eT=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,tT=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,nT=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,iT=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,sT=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,rT=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,oT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,aT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,lT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,cT=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,uT=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,hT=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,fT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,dT=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,pT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,mT=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,gT=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,_T=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,xT=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,vT=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,yT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,bT=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ST=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,MT=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,wT=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,TT=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,AT=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ET=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,CT=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,RT=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,PT=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,IT=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,LT=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,DT=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,NT=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,OT=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,FT=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,UT=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,BT=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,kT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,zT=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,VT=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,GT=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,HT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ht={alphahash_fragment:hw,alphahash_pars_fragment:fw,alphamap_fragment:dw,alphamap_pars_fragment:pw,alphatest_fragment:mw,alphatest_pars_fragment:gw,aomap_fragment:_w,aomap_pars_fragment:xw,batching_pars_vertex:vw,batching_vertex:yw,begin_vertex:bw,beginnormal_vertex:Sw,bsdfs:Mw,iridescence_fragment:ww,bumpmap_pars_fragment:Tw,clipping_planes_fragment:Aw,clipping_planes_pars_fragment:Ew,clipping_planes_pars_vertex:Cw,clipping_planes_vertex:Rw,color_fragment:Pw,color_pars_fragment:Iw,color_pars_vertex:Lw,color_vertex:Dw,common:Nw,defaultnormal_vertex:Ow,displacementmap_pars_vertex:Fw,displacementmap_vertex:Uw,emissivemap_fragment:Bw,emissivemap_pars_fragment:kw,colorspace_fragment:zw,colorspace_pars_fragment:Vw,envmap_fragment:Gw,envmap_common_pars_fragment:Hw,envmap_pars_fragment:Ww,envmap_pars_vertex:Xw,envmap_physical_pars_fragment:n1,envmap_vertex:qw,fog_vertex:$w,fog_pars_vertex:Yw,fog_fragment:Jw,fog_pars_fragment:jw,gradientmap_pars_fragment:Zw,lightmap_pars_fragment:Kw,lights_lambert_fragment:Qw,lights_lambert_pars_fragment:e1,lights_pars_begin:t1,lights_toon_fragment:i1,lights_toon_pars_fragment:s1,lights_phong_fragment:r1,lights_phong_pars_fragment:o1,lights_physical_fragment:a1,lights_physical_pars_fragment:l1,lights_fragment_begin:c1,lights_fragment_maps:u1,lights_fragment_end:h1,lightprobes_pars_fragment:f1,logdepthbuf_fragment:d1,logdepthbuf_pars_fragment:p1,logdepthbuf_pars_vertex:m1,logdepthbuf_vertex:g1,map_fragment:_1,map_pars_fragment:x1,map_particle_fragment:v1,map_particle_pars_fragment:y1,metalnessmap_fragment:b1,metalnessmap_pars_fragment:S1,morphinstance_vertex:M1,morphcolor_vertex:w1,morphnormal_vertex:T1,morphtarget_pars_vertex:A1,morphtarget_vertex:E1,normal_fragment_begin:C1,normal_fragment_maps:R1,normal_pars_fragment:P1,normal_pars_vertex:I1,normal_vertex:L1,normalmap_pars_fragment:D1,clearcoat_normal_fragment_begin:N1,clearcoat_normal_fragment_maps:O1,clearcoat_pars_fragment:F1,iridescence_pars_fragment:U1,opaque_fragment:B1,packing:k1,premultiplied_alpha_fragment:z1,project_vertex:V1,dithering_fragment:G1,dithering_pars_fragment:H1,roughnessmap_fragment:W1,roughnessmap_pars_fragment:X1,shadowmap_pars_fragment:q1,shadowmap_pars_vertex:$1,shadowmap_vertex:Y1,shadowmask_pars_fragment:J1,skinbase_vertex:j1,skinning_pars_vertex:Z1,skinning_vertex:K1,skinnormal_vertex:Q1,specularmap_fragment:eT,specularmap_pars_fragment:tT,tonemapping_fragment:nT,tonemapping_pars_fragment:iT,transmission_fragment:sT,transmission_pars_fragment:rT,uv_pars_fragment:oT,uv_pars_vertex:aT,uv_vertex:lT,worldpos_vertex:cT,background_vert:uT,background_frag:hT,backgroundCube_vert:fT,backgroundCube_frag:dT,cube_vert:pT,cube_frag:mT,depth_vert:gT,depth_frag:_T,distance_vert:xT,distance_frag:vT,equirect_vert:yT,equirect_frag:bT,linedashed_vert:ST,linedashed_frag:MT,meshbasic_vert:wT,meshbasic_frag:TT,meshlambert_vert:AT,meshlambert_frag:ET,meshmatcap_vert:CT,meshmatcap_frag:RT,meshnormal_vert:PT,meshnormal_frag:IT,meshphong_vert:LT,meshphong_frag:DT,meshphysical_vert:NT,meshphysical_frag:OT,meshtoon_vert:FT,meshtoon_frag:UT,points_vert:BT,points_frag:kT,shadow_vert:zT,shadow_frag:VT,sprite_vert:GT,sprite_frag:HT},Ne={common:{diffuse:{value:new it(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new tt},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new tt}},envmap:{envMap:{value:null},envMapRotation:{value:new tt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new tt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new tt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new tt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new tt},normalScale:{value:new Ze(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new tt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new tt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new tt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new tt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new it(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new it(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0},uvTransform:{value:new tt}},sprite:{diffuse:{value:new it(16777215)},opacity:{value:1},center:{value:new Ze(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new tt},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0}}},bs={basic:{uniforms:jn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:jn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new it(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:jn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new it(0)},specular:{value:new it(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:jn([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new it(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:jn([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new it(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:jn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:jn([Ne.points,Ne.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:jn([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:jn([Ne.common,Ne.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:jn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:jn([Ne.sprite,Ne.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new tt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new tt}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:jn([Ne.common,Ne.displacementmap,{referencePosition:{value:new W},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:jn([Ne.lights,Ne.fog,{color:{value:new it(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};bs.physical={uniforms:jn([bs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new tt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new tt},clearcoatNormalScale:{value:new Ze(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new tt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new tt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new tt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new tt},sheen:{value:0},sheenColor:{value:new it(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new tt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new tt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new tt},transmissionSamplerSize:{value:new Ze},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new tt},attenuationDistance:{value:0},attenuationColor:{value:new it(0)},specularColor:{value:new it(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new tt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new tt},anisotropyVector:{value:new Ze},anisotropyMap:{value:null},anisotropyMapTransform:{value:new tt}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var Ah={r:0,b:0,g:0},WT=new mt,jx=new tt;jx.set(-1,0,0,0,1,0,0,0,1);function XT(n,e,t,i,s,r){let o=new it(0),a=s===!0?0:1,l,c,u=null,h=0,f=null;function d(_){let S=_.isScene===!0?_.background:null;if(S&&S.isTexture){let b=_.backgroundBlurriness>0;S=e.get(S,b)}return S}function x(_){let S=!1,b=d(_);b===null?p(o,a):b&&b.isColor&&(p(b,1),S=!0);let M=n.xr.getEnvironmentBlendMode();M==="additive"?t.buffers.color.setClear(0,0,0,1,r):M==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||S)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(_,S){let b=d(S);b&&b.isCubeTexture?(c===void 0&&(c=new Mn(new ha(1,1,1),new zi({name:"BackgroundCubeMaterial",uniforms:ro(bs.backgroundCube.uniforms),vertexShader:bs.backgroundCube.vertexShader,fragmentShader:bs.backgroundCube.fragmentShader,side:ui,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(M,w,g){this.matrixWorld.copyPosition(g.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(WT.makeRotationFromEuler(S.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(jx),c.material.toneMapped=yt.getTransfer(b.colorSpace)!==Pt,(u!==b||h!==b.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,f=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Mn(new bl(2,2),new zi({name:"BackgroundMaterial",uniforms:ro(bs.background.uniforms),vertexShader:bs.background.vertexShader,fragmentShader:bs.background.fragmentShader,side:Tr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.toneMapped=yt.getTransfer(b.colorSpace)!==Pt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,f=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function p(_,S){_.getRGB(Ah,mp(n)),t.buffers.color.setClear(Ah.r,Ah.g,Ah.b,S,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,S=1){o.set(_),a=S,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,p(o,a)},render:x,addToRenderList:y,dispose:m}}function qT(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(D,I,U,N,G){let Y=!1,k=h(D,N,U,I);r!==k&&(r=k,c(r.object)),Y=d(D,N,U,G),Y&&x(D,N,U,G),G!==null&&e.update(G,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,b(D,I,U,N),G!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function u(D){return n.deleteVertexArray(D)}function h(D,I,U,N){let G=N.wireframe===!0,Y=i[I.id];Y===void 0&&(Y={},i[I.id]=Y);let k=D.isInstancedMesh===!0?D.id:0,se=Y[k];se===void 0&&(se={},Y[k]=se);let $=se[U.id];$===void 0&&($={},se[U.id]=$);let Z=$[G];return Z===void 0&&(Z=f(l()),$[G]=Z),Z}function f(D){let I=[],U=[],N=[];for(let G=0;G<t;G++)I[G]=0,U[G]=0,N[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:I,enabledAttributes:U,attributeDivisors:N,object:D,attributes:{},index:null}}function d(D,I,U,N){let G=r.attributes,Y=I.attributes,k=0,se=U.getAttributes();for(let $ in se)if(se[$].location>=0){let q=G[$],ie=Y[$];if(ie===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(ie=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(ie=D.instanceColor)),q===void 0||q.attribute!==ie||ie&&q.data!==ie.data)return!0;k++}return r.attributesNum!==k||r.index!==N}function x(D,I,U,N){let G={},Y=I.attributes,k=0,se=U.getAttributes();for(let $ in se)if(se[$].location>=0){let q=Y[$];q===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(q=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(q=D.instanceColor));let ie={};ie.attribute=q,q&&q.data&&(ie.data=q.data),G[$]=ie,k++}r.attributes=G,r.attributesNum=k,r.index=N}function y(){let D=r.newAttributes;for(let I=0,U=D.length;I<U;I++)D[I]=0}function p(D){m(D,0)}function m(D,I){let U=r.newAttributes,N=r.enabledAttributes,G=r.attributeDivisors;U[D]=1,N[D]===0&&(n.enableVertexAttribArray(D),N[D]=1),G[D]!==I&&(n.vertexAttribDivisor(D,I),G[D]=I)}function _(){let D=r.newAttributes,I=r.enabledAttributes;for(let U=0,N=I.length;U<N;U++)I[U]!==D[U]&&(n.disableVertexAttribArray(U),I[U]=0)}function S(D,I,U,N,G,Y,k){k===!0?n.vertexAttribIPointer(D,I,U,G,Y):n.vertexAttribPointer(D,I,U,N,G,Y)}function b(D,I,U,N){y();let G=N.attributes,Y=U.getAttributes(),k=I.defaultAttributeValues;for(let se in Y){let $=Y[se];if($.location>=0){let Z=G[se];if(Z===void 0&&(se==="instanceMatrix"&&D.instanceMatrix&&(Z=D.instanceMatrix),se==="instanceColor"&&D.instanceColor&&(Z=D.instanceColor)),Z!==void 0){let q=Z.normalized,ie=Z.itemSize,ne=e.get(Z);if(ne===void 0)continue;let K=ne.buffer,he=ne.type,me=ne.bytesPerElement,xe=he===n.INT||he===n.UNSIGNED_INT||Z.gpuType===Vu;if(Z.isInterleavedBufferAttribute){let ve=Z.data,He=ve.isInterleavedBuffer===!0?ve.stride:ve.itemSize,ot=Z.offset;if(ve.isInstancedInterleavedBuffer||ve.isInstancedBufferAttribute){for(let We=0;We<$.locationSize;We++)m($.location+We,ve.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=ve.meshPerAttribute*ve.count)}else for(let We=0;We<$.locationSize;We++)p($.location+We);n.bindBuffer(n.ARRAY_BUFFER,K);for(let We=0;We<$.locationSize;We++)S($.location+We,ie/$.locationSize,he,q,He*me,(ot+ie/$.locationSize*We)*me,xe)}else{if(Z.isInstancedBufferAttribute){for(let ve=0;ve<$.locationSize;ve++)m($.location+ve,Z.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Z.meshPerAttribute*Z.count)}else for(let ve=0;ve<$.locationSize;ve++)p($.location+ve);n.bindBuffer(n.ARRAY_BUFFER,K);for(let ve=0;ve<$.locationSize;ve++)S($.location+ve,ie/$.locationSize,he,q,ie*me,ie/$.locationSize*ve*me,xe)}}else if(k!==void 0){let q=k[se];if(q!==void 0)switch(q.length){case 2:n.vertexAttrib2fv($.location,q);break;case 3:n.vertexAttrib3fv($.location,q);break;case 4:n.vertexAttrib4fv($.location,q);break;default:n.vertexAttrib1fv($.location,q)}}}}_()}function M(){L();for(let D in i){let I=i[D];for(let U in I){let N=I[U];for(let G in N){let Y=N[G];for(let k in Y)u(Y[k].object),delete Y[k];delete N[G]}}delete i[D]}}function w(D){if(i[D.id]===void 0)return;let I=i[D.id];for(let U in I){let N=I[U];for(let G in N){let Y=N[G];for(let k in Y)u(Y[k].object),delete Y[k];delete N[G]}}delete i[D.id]}function g(D){for(let I in i){let U=i[I];for(let N in U){let G=U[N];if(G[D.id]===void 0)continue;let Y=G[D.id];for(let k in Y)u(Y[k].object),delete Y[k];delete G[D.id]}}}function T(D){for(let I in i){let U=i[I],N=D.isInstancedMesh===!0?D.id:0,G=U[N];if(G!==void 0){for(let Y in G){let k=G[Y];for(let se in k)u(k[se].object),delete k[se];delete G[Y]}delete U[N],Object.keys(U).length===0&&delete i[I]}}}function L(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:L,resetDefaultState:P,dispose:M,releaseStatesOfGeometry:w,releaseStatesOfObject:T,releaseStatesOfProgram:g,initAttributes:y,enableAttribute:p,disableUnusedAttributes:_}}function $T(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let f=0;for(let d=0;d<u;d++)f+=c[d];t.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function YT(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let g=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(g.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(g){return!(g!==is&&i.convert(g)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(g){let T=g===ns&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(g!==pi&&g!==Vi&&!T&&i.convert(g)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(g){if(g==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";g="mediump"}return g==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ye("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),S=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),M=n.getParameter(n.MAX_SAMPLES),w=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:x,maxTextureSize:y,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:_,maxVaryings:S,maxFragmentUniforms:b,maxSamples:M,samples:w}}function JT(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Ki,a=new tt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,d){let x=h.clippingPlanes,y=h.clipIntersection,p=h.clipShadows,m=n.get(h);if(!s||x===null||x.length===0||r&&!p)r?u(null):c();else{let _=r?0:i,S=_*4,b=m.clippingState||null;l.value=b,b=u(x,f,S,d);for(let M=0;M!==S;++M)b[M]=t[M];m.clippingState=b,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,f,d,x){let y=h!==null?h.length:0,p=null;if(y!==0){if(p=l.value,x!==!0||p===null){let m=d+y*4,_=f.matrixWorldInverse;a.getNormalMatrix(_),(p===null||p.length<m)&&(p=new Float32Array(m));for(let S=0,b=d;S!==y;++S,b+=4)o.copy(h[S]).applyMatrix4(_,a),o.normal.toArray(p,b),p[b+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,p}}var zl=class extends Ci{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new xl(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new ha(5,5,5),r=new zi({name:"CubemapFromEquirect",uniforms:ro(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ui,blending:to});r.uniforms.tEquirect.value=t;let o=new Mn(s,r),a=t.minFilter;return t.minFilter===Js&&(t.minFilter=ci),new fa(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},Cx=256,jT=3,ZT=20,Zx=256,Kx=16,KT=3,QT=new W,eA=new it,Ch=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new fa(1,10,null),this._boxMesh=new Mn(new ha(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=QT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,x=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(eA));let p=new fa(i,s,u);return p.position.copy(a),p.update(l,e),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=x,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Ix(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Px(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Cx,dp(e))}_fromTexture(e,t){e.mapping===io||e.mapping===ma?this._setSize(e.image.length===0?Cx:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Rx(e,!1,!1),i=Math.log2(e)-jT;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Rx(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===io||e.mapping===ma?(this._cubemapMaterial===null&&(this._cubemapMaterial=Ix()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Px()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=tA(),this._integrationMaterial=nA());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Kx);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-KT)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Zx*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=iA());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function Rx(n,e,t){return new zl(n,{minFilter:Js,generateMipmaps:e,type:ns,colorSpace:al,depthBuffer:t})}function Vl(n,e,t){return new zi({name:n,uniforms:e,vertexShader:ht.cube_vert,fragmentShader:t,side:ui,blending:to,depthTest:!1,depthWrite:!1})}function tA(){return Vl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Zx}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function nA(){return Vl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Kx}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function iA(){return Vl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${ZT}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Px(){return Vl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Ix(){return Vl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function sA(n){let e=new WeakMap,t=new WeakMap,i=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===Bu||d===ku)if(e.has(f)){let x=e.get(f).texture;return a(x,f.mapping)}else{let x=f.image;if(x&&x.height>0){let y=new zl(x.height);return y.fromEquirectangularTexture(n,f),e.set(f,y),f.addEventListener("dispose",c),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,x=d===Bu||d===ku,y=d===io||d===ma;if(x||y){let p=t.get(f),m=p!==void 0?p.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==m)return i===null&&(i=new Ch(n)),p=x?i.fromEquirectangular(f,p):i.fromCubemap(f,p),p.texture.pmremVersion=f.pmremVersion,t.set(f,p),p.texture;if(p!==void 0)return p.texture;{let _=f.image;return x&&_&&_.height>0||y&&_&&l(_)?(i===null&&(i=new Ch(n)),p=x?i.fromEquirectangular(f):i.fromCubemap(f),p.texture.pmremVersion=f.pmremVersion,t.set(f,p),f.addEventListener("dispose",u),p.texture):null}}}return f}function a(f,d){return d===Bu?f.mapping=io:d===ku&&(f.mapping=ma),f}function l(f){let d=0,x=6;for(let y=0;y<x;y++)f[y]!==void 0&&d++;return d===x}function c(f){let d=f.target;d.removeEventListener("dispose",c);let x=e.get(d);x!==void 0&&(e.delete(d),x.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let x=t.get(d);x!==void 0&&(t.delete(d),x.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function rA(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&il("WebGLRenderer: "+i+" extension not supported."),s}}}function oA(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(x=>delete s[x]);function a(x){l(x.target)}function l(x){x.index!==null&&e.remove(x.index);for(let p in x.attributes)e.remove(x.attributes[p]);x.removeEventListener("dispose",a),delete s[x.id],o.unregister(x);let y=r.get(x);y&&(e.remove(y),r.delete(x)),i.releaseStatesOfGeometry(x),x.isInstancedBufferGeometry===!0&&delete x._maxInstanceCount,t.memory.geometries--}function c(x,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function u(x){let y=x.attributes;for(let p in y)e.update(y[p],n.ARRAY_BUFFER)}function h(x){let y=x.index,p=x.attributes.position,m=0;if(p===void 0)return;let _=y!==null?y.array.length:p.array.length/3-1,S=p.count>=65535?Kr:Zr,b=new S(Math.ceil(_/3)*6,1),M=b.array;if(y!==null){let g=y.array;m=y.version;for(let T=0,L=0;T<_;T+=3){let P=g[T+0],D=g[T+1],I=g[T+2];M[L++]=P,M[L++]=D,M[L++]=D,M[L++]=I,M[L++]=I,M[L++]=P}}else{m=p.version;for(let g=0,T=0;g<_;g+=3){let L=g+0,P=g+1,D=g+2;M[T++]=L,M[T++]=P,M[T++]=P,M[T++]=D,M[T++]=D,M[T++]=L}}b.version=m;let w=r.get(x);w&&e.remove(w),r.set(x,b)}function f(x){let y=r.get(x);if(y){let p=x.index;p!==null&&y.version<p.version&&h(x)}else h(x);return r.get(x)}function d(){for(let x in s){let y=s[x].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:f,dispose:d}}function aA(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,f){n.drawElements(i,f,r,h*o),t.update(f,i,1)}function c(h,f,d){d!==0&&(n.drawElementsInstanced(i,f,r,h*o,d),t.update(f,i,d))}function u(h,f,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,h,0,d);let y=0;for(let p=0;p<d;p++)y+=f[p];t.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function lA(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:et("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function cA(n,e,t){let i=new WeakMap,s=new kt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let L=function(){g.dispose(),i.delete(a),a.removeEventListener("dispose",L)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,x=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],S=0;d===!0&&(S=1),x===!0&&(S=2),y===!0&&(S=3);let b=a.attributes.position.count*S,M=1;b>e.maxTextureSize&&(M=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let w=new Float32Array(b*M*4*h),g=new ul(w,b,M,h);g.type=Vi,g.needsUpdate=!0;let T=S*4;for(let P=0;P<h;P++){let D=p[P],I=m[P],U=_[P],N=b*M*4*P;for(let G=0;G<D.count;G++){let Y=G*T;d===!0&&(s.fromBufferAttribute(D,G),w[N+Y+0]=s.x,w[N+Y+1]=s.y,w[N+Y+2]=s.z,w[N+Y+3]=0),x===!0&&(s.fromBufferAttribute(I,G),w[N+Y+4]=s.x,w[N+Y+5]=s.y,w[N+Y+6]=s.z,w[N+Y+7]=0),y===!0&&(s.fromBufferAttribute(U,G),w[N+Y+8]=s.x,w[N+Y+9]=s.y,w[N+Y+10]=s.z,w[N+Y+11]=U.itemSize===4?s.w:1)}}f={count:h,texture:g,size:new Ze(b,M)},i.set(a,f),a.addEventListener("dispose",L)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let x=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",x),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function uA(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,f=e.get(c,h);if(r.get(f)!==u&&(e.update(f),r.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return f}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var hA={[$d]:"LINEAR_TONE_MAPPING",[Yd]:"REINHARD_TONE_MAPPING",[Jd]:"CINEON_TONE_MAPPING",[jd]:"ACES_FILMIC_TONE_MAPPING",[Kd]:"AGX_TONE_MAPPING",[Qd]:"NEUTRAL_TONE_MAPPING",[Zd]:"CUSTOM_TONE_MAPPING"};function fA(n,e,t,i,s,r){let o=new Ci(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Jn;u.setAttribute("position",new Cn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Cn([0,2,0,0,2,0],2));let h=new Mu({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new Mn(u,h),d=new Pi(-1,1,1,-1,0,1),x=null,y=null,p=!1,m,_=null,S=[],b=!1;this.setSize=function(M,w){o.setSize(M,w),a!==null&&a.setSize(M,w),l!==null&&l.setSize(M,w);for(let g=0;g<S.length;g++){let T=S[g];T.setSize&&T.setSize(M,w)}},this.setEffects=function(M){S=M,b=S.length>0&&S[0].isRenderPass===!0;let w=o.width,g=o.height;S.length>0&&a===null&&(a=new Ci(w,g,{type:ns,depthBuffer:!1,stencilBuffer:!1}),l=new Ci(w,g,{type:ns,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&S.some(L=>L.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Ys(w,g),r===!0&&(c.format=js,c.type=so)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let L=0;L<S.length;L++){let P=S[L];P.setSize&&P.setSize(w,g),T&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(M,w){if(p||M.toneMapping===vs&&S.length===0)return!1;if(_=w,w!==null){let g=w.width,T=w.height;(o.width!==g||o.height!==T)&&this.setSize(g,T)}return b===!1&&M.setRenderTarget(o),m=M.toneMapping,M.toneMapping=vs,!0},this.hasRenderPass=function(){return b},this.end=function(M,w){M.toneMapping=m,p=!0;let g=o,T=a;for(let L=0;L<S.length;L++){let P=S[L];P.enabled!==!1&&(P.render(M,T,g,w),P.needsSwap!==!1&&(g=T,T=T===a?l:a))}if(x!==M.outputColorSpace||y!==M.toneMapping){x=M.outputColorSpace,y=M.toneMapping,h.defines={},yt.getTransfer(x)===Pt&&(h.defines.SRGB_TRANSFER="");let L=hA[y];L&&(h.defines[L]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=g.texture,M.setRenderTarget(_),M.render(f,d),_=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Qx=new fi,ev=new Ys(1,1),tv=new vl(1),nv=new ul,iv=new xu,sv=new xl,Lx=[],Dx=[],Nx=new Float32Array(16),Ox=new Float32Array(9),Fx=new Float32Array(4);function va(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=Lx[s];if(r===void 0&&(r=new Float32Array(s),Lx[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Rn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Pn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Rh(n,e){let t=Dx[e];t===void 0&&(t=new Int32Array(e),Dx[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function dA(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function pA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rn(t,e))return;n.uniform2fv(this.addr,e),Pn(t,e)}}function mA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Rn(t,e))return;n.uniform3fv(this.addr,e),Pn(t,e)}}function gA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rn(t,e))return;n.uniform4fv(this.addr,e),Pn(t,e)}}function _A(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Rn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Pn(t,e)}else{if(Rn(t,i))return;Fx.set(i),n.uniformMatrix2fv(this.addr,!1,Fx),Pn(t,i)}}function xA(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Rn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Pn(t,e)}else{if(Rn(t,i))return;Ox.set(i),n.uniformMatrix3fv(this.addr,!1,Ox),Pn(t,i)}}function vA(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Rn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Pn(t,e)}else{if(Rn(t,i))return;Nx.set(i),n.uniformMatrix4fv(this.addr,!1,Nx),Pn(t,i)}}function yA(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function bA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rn(t,e))return;n.uniform2iv(this.addr,e),Pn(t,e)}}function SA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Rn(t,e))return;n.uniform3iv(this.addr,e),Pn(t,e)}}function MA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rn(t,e))return;n.uniform4iv(this.addr,e),Pn(t,e)}}function wA(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function TA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rn(t,e))return;n.uniform2uiv(this.addr,e),Pn(t,e)}}function AA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Rn(t,e))return;n.uniform3uiv(this.addr,e),Pn(t,e)}}function EA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rn(t,e))return;n.uniform4uiv(this.addr,e),Pn(t,e)}}function Ph(n){return n.version===0&&(n.compareFunction=cp,n.needsUpdate=!0),n}function CA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Ph(ev):r=Qx,t.setTexture2D(e||r,s)}function RA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||iv,s)}function PA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Ph(tv):r=sv,t.setTextureCube(e||r,s)}function IA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||nv,s)}function LA(n){switch(n){case 5126:return dA;case 35664:return pA;case 35665:return mA;case 35666:return gA;case 35674:return _A;case 35675:return xA;case 35676:return vA;case 5124:case 35670:return yA;case 35667:case 35671:return bA;case 35668:case 35672:return SA;case 35669:case 35673:return MA;case 5125:return wA;case 36294:return TA;case 36295:return AA;case 36296:return EA;case 35678:case 36198:case 36298:case 36306:case 35682:return CA;case 35679:case 36299:case 36307:return RA;case 35680:case 36300:case 36308:case 36293:return PA;case 36289:case 36303:case 36311:case 36292:return IA}}function DA(n,e){n.uniform1fv(this.addr,e)}function NA(n,e){let t=va(e,this.size,2);n.uniform2fv(this.addr,t)}function OA(n,e){let t=va(e,this.size,3);n.uniform3fv(this.addr,t)}function FA(n,e){let t=va(e,this.size,4);n.uniform4fv(this.addr,t)}function UA(n,e){let t=va(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function BA(n,e){let t=va(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function kA(n,e){let t=va(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function zA(n,e){n.uniform1iv(this.addr,e)}function VA(n,e){n.uniform2iv(this.addr,e)}function GA(n,e){n.uniform3iv(this.addr,e)}function HA(n,e){n.uniform4iv(this.addr,e)}function WA(n,e){n.uniform1uiv(this.addr,e)}function XA(n,e){n.uniform2uiv(this.addr,e)}function qA(n,e){n.uniform3uiv(this.addr,e)}function $A(n,e){n.uniform4uiv(this.addr,e)}function YA(n,e,t){let i=this.cache,s=e.length,r=Rh(t,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Pn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Ph(ev):o=Qx;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function JA(n,e,t){let i=this.cache,s=e.length,r=Rh(t,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Pn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||iv,r[o])}function jA(n,e,t){let i=this.cache,s=e.length,r=Rh(t,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Pn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Ph(tv):o=sv;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function ZA(n,e,t){let i=this.cache,s=e.length,r=Rh(t,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Pn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||nv,r[o])}function KA(n){switch(n){case 5126:return DA;case 35664:return NA;case 35665:return OA;case 35666:return FA;case 35674:return UA;case 35675:return BA;case 35676:return kA;case 5124:case 35670:return zA;case 35667:case 35671:return VA;case 35668:case 35672:return GA;case 35669:case 35673:return HA;case 5125:return WA;case 36294:return XA;case 36295:return qA;case 36296:return $A;case 35678:case 36198:case 36298:case 36306:case 35682:return YA;case 35679:case 36299:case 36307:return JA;case 35680:case 36300:case 36308:case 36293:return jA;case 36289:case 36303:case 36311:case 36292:return ZA}}var bp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=LA(t.type)}},Sp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=KA(t.type)}},Mp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},vp=/(\w+)(\])?(\[|\.)?/g;function Ux(n,e){n.seq.push(e),n.map[e.id]=e}function QA(n,e,t){let i=n.name,s=i.length;for(vp.lastIndex=0;;){let r=vp.exec(i),o=vp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Ux(t,c===void 0?new bp(a,n,e):new Sp(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new Mp(a),Ux(t,h)),t=h}}}var xa=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);QA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function Bx(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var eE=37297,tE=0;function nE(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var kx=new tt;function iE(n){yt._getMatrix(kx,yt.workingColorSpace,n);let e=`mat3( ${kx.elements.map(t=>t.toFixed(4))} )`;switch(yt.getTransfer(n)){case ll:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function zx(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+nE(n.getShaderSource(e),a)}else return r}function sE(n,e){let t=iE(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var rE={[$d]:"Linear",[Yd]:"Reinhard",[Jd]:"Cineon",[jd]:"ACESFilmic",[Kd]:"AgX",[Qd]:"Neutral",[Zd]:"Custom"};function oE(n,e){let t=rE[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Eh=new W;function aE(){yt.getLuminanceCoefficients(Eh);let n=Eh.x.toFixed(4),e=Eh.y.toFixed(4),t=Eh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function lE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(kl).join(`
`)}function cE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function uE(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function kl(n){return n!==""}function Vx(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Gx(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var hE=/^[ \t]*#include +<([\w\d./]+)>/gm;function wp(n){return n.replace(hE,fE)}function fE(n,e){let t=ht[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return wp(t)}var dE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Hx(n){return n.replace(dE,pE)}function pE(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Wx(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var mE={[Pl]:"SHADOWMAP_TYPE_PCF",[da]:"SHADOWMAP_TYPE_VSM"};function gE(n){return mE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var _E={[ma]:"ENVMAP_MODE_REFRACTION"};function xE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":_E[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var vE={[Uu]:"ENVMAP_BLENDING_MULTIPLY",[ox]:"ENVMAP_BLENDING_MIX",[ax]:"ENVMAP_BLENDING_ADD"};function yE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":vE[n.combine]||"ENVMAP_BLENDING_NONE"}function bE(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=gE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=xE(t),h=yE(t),f=lE(t),d=cE(r),x=s.createProgram(),y,p,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(kl).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(kl).join(`
`),p.length>0&&(p+=`
`)):(y=[Wx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(kl).join(`
`),p=[Wx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==vs?"#define TONE_MAPPING":"",t.toneMapping!==vs?ht.tonemapping_pars_fragment:"",t.toneMapping!==vs?oE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,sE("linearToOutputTexel",t.outputColorSpace),aE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(kl).join(`
`)),o=wp(o),o=Vx(o,t),o=Gx(o,t),a=wp(a),a=Vx(a,t),a=Gx(a,t),o=Hx(o),a=Hx(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",t.glslVersion===up?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===up?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let _=m+y+o,S=m+p+a,b=Bx(s,s.VERTEX_SHADER,_),M=Bx(s,s.FRAGMENT_SHADER,S);s.attachShader(x,b),s.attachShader(x,M),t.index0AttributeName!==void 0?s.bindAttribLocation(x,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(x,0,"position"),s.linkProgram(x);function w(P){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(x)||"",I=s.getShaderInfoLog(b)||"",U=s.getShaderInfoLog(M)||"",N=D.trim(),G=I.trim(),Y=U.trim(),k=!0,se=!0;if(s.getProgramParameter(x,s.LINK_STATUS)===!1)if(k=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,x,b,M);else{let $=zx(s,b,"vertex"),Z=zx(s,M,"fragment");et("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(x,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+N+`
`+$+`
`+Z)}else N!==""?Ye("WebGLProgram: Program Info Log:",N):(G===""||Y==="")&&(se=!1);se&&(P.diagnostics={runnable:k,programLog:N,vertexShader:{log:G,prefix:y},fragmentShader:{log:Y,prefix:p}})}s.deleteShader(b),s.deleteShader(M),g=new xa(s,x),T=uE(s,x)}let g;this.getUniforms=function(){return g===void 0&&w(this),g};let T;this.getAttributes=function(){return T===void 0&&w(this),T};let L=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return L===!1&&(L=s.getProgramParameter(x,eE)),L},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(x),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=tE++,this.cacheKey=e,this.usedTimes=1,this.program=x,this.vertexShader=b,this.fragmentShader=M,this}var SE=0,Tp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Ap(e),t.set(e,i)),i}},Ap=class{constructor(e){this.id=SE++,this.code=e,this.usedTimes=0}};function ME(n){return n===Ar||n===Fl||n===Ul}function wE(n,e,t,i,s,r){let o=new aa,a=new Tp,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(g){return l.add(g),g===0?"uv":`uv${g}`}function x(g,T,L,P,D,I){let U=P.fog,N=D.geometry,G=g.isMeshStandardMaterial||g.isMeshLambertMaterial||g.isMeshPhongMaterial?P.environment:null,Y=g.isMeshStandardMaterial||g.isMeshLambertMaterial&&!g.envMap||g.isMeshPhongMaterial&&!g.envMap,k=e.get(g.envMap||G,Y),se=f[g.type],$=i.precision;g.precision!==null&&($=i.getMaxPrecision(g.precision),$!==g.precision&&Ye("WebGLProgram.getParameters:",g.precision,"not supported, using",$,"instead."));let Z=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,q=Z!==void 0?Z.length:0,ie=0;N.morphAttributes.position!==void 0&&(ie=1),N.morphAttributes.normal!==void 0&&(ie=2),N.morphAttributes.color!==void 0&&(ie=3);let ne,K,he,me;if(se){let Pe=bs[se];ne=Pe.vertexShader,K=Pe.fragmentShader}else{ne=g.vertexShader,K=g.fragmentShader;let Pe=a.getVertexShaderStage(g),lt=a.getFragmentShaderStage(g);a.update(g,Pe,lt),he=Pe.id,me=lt.id}let xe=n.getRenderTarget(),ve=n.state.buffers.depth.getReversed(),He=D.isInstancedMesh===!0,ot=D.isBatchedMesh===!0,We=!!g.map,ft=!!g.matcap,ct=!!k,st=ct&&k.isPMREMTexture===!0,Qt=!!g.aoMap,Wt=!!g.lightMap,dn=!!g.bumpMap&&g.wireframe===!1,Ut=!!g.normalMap,In=!!g.displacementMap,St=!!g.emissiveMap,wn=!!g.metalnessMap,sn=!!g.roughnessMap,pn=g.anisotropy>0,V=g.clearcoat>0,Ie=g.diffuseRoughness>0,Je=g.dispersion>0,at=g.retroreflectivity>0,Te=g.iridescence>0,zt=g.sheen>0,Ge=g.transmission>0,$e=pn&&!!g.anisotropyMap,O=V&&!!g.clearcoatMap,E=V&&!!g.clearcoatNormalMap,J=V&&!!g.clearcoatRoughnessMap,de=Ie&&!!g.diffuseRoughnessMap,ce=Te&&!!g.iridescenceMap,be=Te&&!!g.iridescenceThicknessMap,Se=zt&&!!g.sheenColorMap,re=zt&&!!g.sheenRoughnessMap,ae=!!g.specularMap,_e=!!g.specularColorMap,z=!!g.specularIntensityMap,le=Ge&&!!g.transmissionMap,oe=Ge&&!!g.thicknessMap,Ae=!!g.gradientMap,ye=!!g.alphaMap,we=g.alphaTest>0,Xe=!!g.alphaHash,Ke=!!g.extensions,fe=vs;g.toneMapped&&(xe===null||xe.isXRRenderTarget===!0)&&(fe=n.toneMapping);let ke=st?k.isCompressedCubeTexture?k.image[0].mipmaps:k.mipmaps:null,Qe={shaderID:se,shaderType:g.type,shaderName:g.name,vertexShader:ne,fragmentShader:K,defines:g.defines,customVertexShaderID:he,customFragmentShaderID:me,isRawShaderMaterial:g.isRawShaderMaterial===!0,glslVersion:g.glslVersion,precision:$,batching:ot,batchingColor:ot&&D._colorsTexture!==null,instancing:He,instancingColor:He&&D.instanceColor!==null,instancingMorph:He&&D.morphTexture!==null,outputColorSpace:xe===null?n.outputColorSpace:xe.isXRRenderTarget===!0?xe.texture.colorSpace:yt.workingColorSpace,alphaToCoverage:!!g.alphaToCoverage,map:We,matcap:ft,envMap:ct,envMapMode:ct&&k.mapping,envMapPMREM:st,envMapMaxLod:st?ke.length-1:null,envMapSize:st?ke[0].width:null,aoMap:Qt,lightMap:Wt,bumpMap:dn,normalMap:Ut,displacementMap:In,emissiveMap:St,normalMapObjectSpace:Ut&&g.normalMapType===ux,normalMapTangentSpace:Ut&&g.normalMapType===wh,packedNormalMap:Ut&&g.normalMapType===wh&&ME(g.normalMap.format),metalnessMap:wn,roughnessMap:sn,anisotropy:pn,anisotropyMap:$e,clearcoat:V,clearcoatMap:O,clearcoatNormalMap:E,clearcoatRoughnessMap:J,diffuseRoughness:Ie,diffuseRoughnessMap:de,dispersion:Je,retroreflection:at,iridescence:Te,iridescenceMap:ce,iridescenceThicknessMap:be,sheen:zt,sheenColorMap:Se,sheenRoughnessMap:re,specularMap:ae,specularColorMap:_e,specularIntensityMap:z,transmission:Ge,transmissionMap:le,thicknessMap:oe,gradientMap:Ae,opaque:g.transparent===!1&&g.blending===pa&&g.alphaToCoverage===!1,alphaMap:ye,alphaTest:we,alphaHash:Xe,combine:g.combine,mapUv:We&&d(g.map.channel),aoMapUv:Qt&&d(g.aoMap.channel),lightMapUv:Wt&&d(g.lightMap.channel),bumpMapUv:dn&&d(g.bumpMap.channel),normalMapUv:Ut&&d(g.normalMap.channel),displacementMapUv:In&&d(g.displacementMap.channel),emissiveMapUv:St&&d(g.emissiveMap.channel),metalnessMapUv:wn&&d(g.metalnessMap.channel),roughnessMapUv:sn&&d(g.roughnessMap.channel),anisotropyMapUv:$e&&d(g.anisotropyMap.channel),clearcoatMapUv:O&&d(g.clearcoatMap.channel),clearcoatNormalMapUv:E&&d(g.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:J&&d(g.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:de&&d(g.diffuseRoughnessMap.channel),iridescenceMapUv:ce&&d(g.iridescenceMap.channel),iridescenceThicknessMapUv:be&&d(g.iridescenceThicknessMap.channel),sheenColorMapUv:Se&&d(g.sheenColorMap.channel),sheenRoughnessMapUv:re&&d(g.sheenRoughnessMap.channel),specularMapUv:ae&&d(g.specularMap.channel),specularColorMapUv:_e&&d(g.specularColorMap.channel),specularIntensityMapUv:z&&d(g.specularIntensityMap.channel),transmissionMapUv:le&&d(g.transmissionMap.channel),thicknessMapUv:oe&&d(g.thicknessMap.channel),alphaMapUv:ye&&d(g.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Ut||pn),vertexNormals:!!N.attributes.normal,vertexColors:g.vertexColors,vertexAlphas:g.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!N.attributes.uv&&(We||ye),fog:!!U,useFog:g.fog===!0,fogExp2:!!U&&U.isFogExp2,flatShading:g.wireframe===!1&&(g.flatShading===!0||N.attributes.normal===void 0&&Ut===!1&&(g.isMeshLambertMaterial||g.isMeshPhongMaterial||g.isMeshStandardMaterial||g.isMeshPhysicalMaterial)),sizeAttenuation:g.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:ve,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:q,morphTextureStride:ie,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:I.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:g.dithering,shadowMapEnabled:n.shadowMap.enabled&&L.length>0,shadowMapType:n.shadowMap.type,toneMapping:fe,decodeVideoTexture:We&&g.map.isVideoTexture===!0&&yt.getTransfer(g.map.colorSpace)===Pt,decodeVideoTextureEmissive:St&&g.emissiveMap.isVideoTexture===!0&&yt.getTransfer(g.emissiveMap.colorSpace)===Pt,premultipliedAlpha:g.premultipliedAlpha,doubleSided:g.side===di,flipSided:g.side===ui,useDepthPacking:g.depthPacking>=0,depthPacking:g.depthPacking||0,index0AttributeName:g.index0AttributeName,extensionClipCullDistance:Ke&&g.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ke&&g.extensions.multiDraw===!0||ot)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:g.customProgramCacheKey()};return Qe.vertexUv1s=l.has(1),Qe.vertexUv2s=l.has(2),Qe.vertexUv3s=l.has(3),l.clear(),Qe}function y(g){let T=[];if(g.shaderID?T.push(g.shaderID):(T.push(g.customVertexShaderID),T.push(g.customFragmentShaderID)),g.defines!==void 0)for(let L in g.defines)T.push(L),T.push(g.defines[L]);return g.isRawShaderMaterial===!1&&(p(T,g),m(T,g),T.push(n.outputColorSpace)),T.push(g.customProgramCacheKey),T.join()}function p(g,T){g.push(T.precision),g.push(T.outputColorSpace),g.push(T.envMapMode),g.push(T.envMapPMREM),g.push(T.envMapMaxLod),g.push(T.envMapSize),g.push(T.mapUv),g.push(T.alphaMapUv),g.push(T.lightMapUv),g.push(T.aoMapUv),g.push(T.bumpMapUv),g.push(T.normalMapUv),g.push(T.displacementMapUv),g.push(T.emissiveMapUv),g.push(T.metalnessMapUv),g.push(T.roughnessMapUv),g.push(T.anisotropyMapUv),g.push(T.clearcoatMapUv),g.push(T.clearcoatNormalMapUv),g.push(T.clearcoatRoughnessMapUv),g.push(T.diffuseRoughnessMapUv),g.push(T.iridescenceMapUv),g.push(T.iridescenceThicknessMapUv),g.push(T.sheenColorMapUv),g.push(T.sheenRoughnessMapUv),g.push(T.specularMapUv),g.push(T.specularColorMapUv),g.push(T.specularIntensityMapUv),g.push(T.transmissionMapUv),g.push(T.thicknessMapUv),g.push(T.combine),g.push(T.fogExp2),g.push(T.sizeAttenuation),g.push(T.morphTargetsCount),g.push(T.numSunLights),g.push(T.numDirLights),g.push(T.numPointLights),g.push(T.numSpotLights),g.push(T.numSpotLightMaps),g.push(T.numHemiLights),g.push(T.numRectAreaLights),g.push(T.numSunLightShadows),g.push(T.numDirLightShadows),g.push(T.numPointLightShadows),g.push(T.numSpotLightShadows),g.push(T.numSpotLightShadowsWithMaps),g.push(T.numLightProbes),g.push(T.numLightProbeGrids),g.push(T.shadowMapType),g.push(T.toneMapping),g.push(T.numClippingPlanes),g.push(T.numClipIntersection),g.push(T.depthPacking)}function m(g,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),g.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),g.push(o.mask)}function _(g){let T=f[g.type],L;if(T){let P=bs[T];L=Tx.clone(P.uniforms)}else L=g.uniforms;return L}function S(g,T){let L=u.get(T);return L!==void 0?++L.usedTimes:(L=new bE(n,T,g,s),c.push(L),u.set(T,L)),L}function b(g){if(--g.usedTimes===0){let T=c.indexOf(g);c[T]=c[c.length-1],c.pop(),u.delete(g.cacheKey),g.destroy()}}function M(g){a.remove(g)}function w(){a.dispose()}return{getParameters:x,getProgramCacheKey:y,getUniforms:_,acquireProgram:S,releaseProgram:b,releaseShaderCache:M,programs:c,dispose:w}}function TE(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function AE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Xx(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function qx(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,x,y,p,m){let _=n[e];return _===void 0?(_={id:f.id,object:f,geometry:d,material:x,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:p,group:m},n[e]=_):(_.id=f.id,_.object=f,_.geometry=d,_.material=x,_.materialVariant=o(f),_.groupOrder=y,_.renderOrder=f.renderOrder,_.z=p,_.group=m),e++,_}function l(f,d,x,y,p,m,_){_.reversedDepth===!0&&(p=-p);let S=a(f,d,x,y,p,m);x.transmission>0?i.push(S):x.transparent===!0?s.push(S):t.push(S)}function c(f,d,x,y,p,m){let _=a(f,d,x,y,p,m);x.transmission>0?i.unshift(_):x.transparent===!0?s.unshift(_):t.unshift(_)}function u(f,d){t.length>1&&t.sort(f||AE),i.length>1&&i.sort(d||Xx),s.length>1&&s.sort(d||Xx)}function h(){for(let f=e,d=n.length;f<d;f++){let x=n[f];if(x.id===null)break;x.id=null,x.object=null,x.geometry=null,x.material=null,x.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function EE(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new qx,n.set(i,[o])):s>=r.length?(o=new qx,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function CE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new W,color:new it};break;case"SpotLight":t={position:new W,direction:new W,color:new it,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new W,color:new it,distance:0,decay:0};break;case"HemisphereLight":t={direction:new W,skyColor:new it,groundColor:new it};break;case"RectAreaLight":t={color:new it,position:new W,halfWidth:new W,halfHeight:new W};break}return n[e.id]=t,t}}}function RE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var PE=0;function IE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function LE(n){let e=new CE,t=RE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new W);let s=new W,r=new mt,o=new mt;function a(c){let u=0,h=0,f=0;for(let I=0;I<9;I++)i.probe[I].set(0,0,0);let d=0,x=0,y=0,p=0,m=0,_=0,S=0,b=0,M=0,w=0,g=0,T=0,L=0,P=0;c.sort(IE);for(let I=0,U=c.length;I<U;I++){let N=c[I],G=N.color,Y=N.intensity,k=N.distance,se=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Ar?se=N.shadow.map.texture:se=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=G.r*Y,h+=G.g*Y,f+=G.b*Y;else if(N.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(N.sh.coefficients[$],Y);P++}else if(N.isSunLight){let $=e.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Z=N.shadow,q=t.get(N);q.shadowIntensity=Z.intensity,q.shadowBias=Z.bias,q.shadowNormalBias=Z.normalBias,q.shadowRadius=Z.radius,q.shadowMapSize.copy(Z.mapSize).multiply(Z.getFrameExtents()),i.sunShadow[x]=q,i.sunShadowMap[x]=se;let ie=Z.getViewportCount();for(let ne=0;ne<ie;ne++)i.sunShadowMatrix[y+ne]=Z.getMatrix(ne),i.sunShadowCascade[y+ne]=Z._cascadeData[ne];y+=ie,x++}i.sun[d]=$,d++}else if(N.isDirectionalLight){let $=e.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Z=N.shadow,q=t.get(N);q.shadowIntensity=Z.intensity,q.shadowBias=Z.bias,q.shadowNormalBias=Z.normalBias,q.shadowRadius=Z.radius,q.shadowMapSize=Z.mapSize,i.directionalShadow[p]=q,i.directionalShadowMap[p]=se,i.directionalShadowMatrix[p]=N.shadow.matrix,M++}i.directional[p]=$,p++}else if(N.isSpotLight){let $=e.get(N);$.position.setFromMatrixPosition(N.matrixWorld),$.color.copy(G).multiplyScalar(Y),$.distance=k,$.coneCos=Math.cos(N.angle),$.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),$.decay=N.decay,i.spot[_]=$;let Z=N.shadow;if(N.map&&(i.spotLightMap[T]=N.map,T++,Z.updateMatrices(N),N.castShadow&&L++),i.spotLightMatrix[_]=Z.matrix,N.castShadow){let q=t.get(N);q.shadowIntensity=Z.intensity,q.shadowBias=Z.bias,q.shadowNormalBias=Z.normalBias,q.shadowRadius=Z.radius,q.shadowMapSize=Z.mapSize,i.spotShadow[_]=q,i.spotShadowMap[_]=se,g++}_++}else if(N.isRectAreaLight){let $=e.get(N);$.color.copy(G).multiplyScalar(Y),$.halfWidth.set(N.width*.5,0,0),$.halfHeight.set(0,N.height*.5,0),i.rectArea[S]=$,S++}else if(N.isPointLight){let $=e.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),$.distance=N.distance,$.decay=N.decay,N.castShadow){let Z=N.shadow,q=t.get(N);q.shadowIntensity=Z.intensity,q.shadowBias=Z.bias,q.shadowNormalBias=Z.normalBias,q.shadowRadius=Z.radius,q.shadowMapSize=Z.mapSize,q.shadowCameraNear=Z.camera.near,q.shadowCameraFar=Z.camera.far,i.pointShadow[m]=q,i.pointShadowMap[m]=se,i.pointShadowMatrix[m]=N.shadow.matrix,w++}i.point[m]=$,m++}else if(N.isHemisphereLight){let $=e.get(N);$.skyColor.copy(N.color).multiplyScalar(Y),$.groundColor.copy(N.groundColor).multiplyScalar(Y),i.hemi[b]=$,b++}}S>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ne.LTC_FLOAT_1,i.rectAreaLTC2=Ne.LTC_FLOAT_2):(i.rectAreaLTC1=Ne.LTC_HALF_1,i.rectAreaLTC2=Ne.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let D=i.hash;(D.sunLength!==d||D.directionalLength!==p||D.pointLength!==m||D.spotLength!==_||D.rectAreaLength!==S||D.hemiLength!==b||D.numSunShadows!==x||D.numDirectionalShadows!==M||D.numPointShadows!==w||D.numSpotShadows!==g||D.numSpotMaps!==T||D.numLightProbes!==P)&&(i.sun.length=d,i.directional.length=p,i.spot.length=_,i.rectArea.length=S,i.point.length=m,i.hemi.length=b,i.sunShadow.length=x,i.sunShadowMap.length=x,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=M,i.directionalShadowMap.length=M,i.directionalShadowMatrix.length=M,i.pointShadow.length=w,i.pointShadowMap.length=w,i.pointShadowMatrix.length=w,i.spotShadow.length=g,i.spotShadowMap.length=g,i.spotLightMatrix.length=g+T-L,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=L,i.numLightProbes=P,D.sunLength=d,D.directionalLength=p,D.pointLength=m,D.spotLength=_,D.rectAreaLength=S,D.hemiLength=b,D.numSunShadows=x,D.numDirectionalShadows=M,D.numPointShadows=w,D.numSpotShadows=g,D.numSpotMaps=T,D.numLightProbes=P,i.version=PE++)}function l(c,u){let h=0,f=0,d=0,x=0,y=0,p=0,m=u.matrixWorldInverse;for(let _=0,S=c.length;_<S;_++){let b=c[_];if(b.isSunLight){let M=i.sun[h];M.direction.setFromMatrixPosition(b.matrixWorld),M.direction.transformDirection(m),h++}else if(b.isDirectionalLight){let M=i.directional[f];M.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),M.direction.sub(s),M.direction.transformDirection(m),f++}else if(b.isSpotLight){let M=i.spot[x];M.position.setFromMatrixPosition(b.matrixWorld),M.position.applyMatrix4(m),M.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),M.direction.sub(s),M.direction.transformDirection(m),x++}else if(b.isRectAreaLight){let M=i.rectArea[y];M.position.setFromMatrixPosition(b.matrixWorld),M.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),M.halfWidth.set(b.width*.5,0,0),M.halfHeight.set(0,b.height*.5,0),M.halfWidth.applyMatrix4(o),M.halfHeight.applyMatrix4(o),y++}else if(b.isPointLight){let M=i.point[d];M.position.setFromMatrixPosition(b.matrixWorld),M.position.applyMatrix4(m),d++}else if(b.isHemisphereLight){let M=i.hemi[p];M.direction.setFromMatrixPosition(b.matrixWorld),M.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:i}}function $x(n){let e=new LE(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function DE(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new $x(n),e.set(s,[a])):r>=o.length?(a=new $x(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var NE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,OE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,FE=[new W(1,0,0),new W(-1,0,0),new W(0,1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1)],UE=[new W(0,-1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1),new W(0,-1,0),new W(0,-1,0)],Yx=new mt,Bl=new W,yp=new W;function BE(n,e,t){let i=new vr,s=new Ze,r=new Ze,o=new kt,a=new wu,l=new Tu,c={},u=t.maxTextureSize,h={[Tr]:ui,[ui]:Tr,[di]:di},f=new zi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ze},radius:{value:4}},vertexShader:NE,fragmentShader:OE}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let x=new Jn;x.setAttribute("position",new Ft(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Mn(x,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Pl;let m=this.type;this.render=function(w,g,T){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||w.length===0)return;this.type===V_&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Pl);let L=n.getRenderTarget(),P=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),I=n.state;I.setBlending(to),I.buffers.depth.getReversed()===!0?I.buffers.color.setClear(0,0,0,0):I.buffers.color.setClear(1,1,1,1),I.buffers.depth.setTest(!0),I.setScissorTest(!1);let U=m!==this.type;U&&g.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(G=>G.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,G=w.length;N<G;N++){let Y=w[N],k=Y.shadow;if(k===void 0){Ye("WebGLShadowMap:",Y,"has no shadow.");continue}if(k.autoUpdate===!1&&k.needsUpdate===!1)continue;s.copy(k.mapSize);let se=k.getFrameExtents();s.multiply(se),r.copy(k.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/se.x),s.x=r.x*se.x,k.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/se.y),s.y=r.y*se.y,k.mapSize.y=r.y));let $=n.state.buffers.depth.getReversed();if(k.camera._reversedDepth=$,k.map===null||U===!0){if(k.map!==null&&(k.map.depthTexture!==null&&(k.map.depthTexture.dispose(),k.map.depthTexture=null),k.map.dispose()),this.type===da){if(Y.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}k.map=new Ci(s.x,s.y,{format:Ar,type:ns,minFilter:ci,magFilter:ci,generateMipmaps:!1}),k.map.texture.name=Y.name+".shadowMap",k.map.depthTexture=new Ys(s.x,s.y,Vi),k.map.depthTexture.name=Y.name+".shadowMapDepth",k.map.depthTexture.format=Gs,k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Bn,k.map.depthTexture.magFilter=Bn}else Y.isPointLight?(k.map=new zl(s.x),k.map.depthTexture=new vl(s.x,ts)):(k.map=new Ci(s.x,s.y),k.map.depthTexture=new Ys(s.x,s.y,ts)),k.map.depthTexture.name=Y.name+".shadowMap",k.map.depthTexture.format=Gs,this.type===Pl?(k.map.depthTexture.compareFunction=$?lp:ap,k.map.depthTexture.minFilter=ci,k.map.depthTexture.magFilter=ci):(k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Bn,k.map.depthTexture.magFilter=Bn);k.camera.updateProjectionMatrix()}k.map.isWebGLCubeRenderTarget!==!0&&(k.map.width!==s.x||k.map.height!==s.y)&&k.map.setSize(s.x,s.y);let Z=k.map.isWebGLCubeRenderTarget?6:k.getViewportCount();Y.isPointLight!==!0&&k.updateMatrices(Y,T);let q=(k.camera.layers.mask&4294967294)!==0?k.camera.layers:T.layers;for(let ie=0;ie<Z;ie++){let ne=k.getCamera(ie);if(Y.isPointLight){let K=k.camera,he=k.matrix,me=Y.distance||K.far;me!==K.far&&(K.far=me,K.updateProjectionMatrix()),Bl.setFromMatrixPosition(Y.matrixWorld),K.position.copy(Bl),yp.copy(K.position),yp.add(FE[ie]),K.up.copy(UE[ie]),K.lookAt(yp),K.updateMatrixWorld(),he.makeTranslation(-Bl.x,-Bl.y,-Bl.z),Yx.multiplyMatrices(K.projectionMatrix,K.matrixWorldInverse),k._frustum.setFromProjectionMatrix(Yx,K.coordinateSystem,K.reversedDepth)}if(k.map.isWebGLCubeRenderTarget)n.setRenderTarget(k.map,ie),n.clear();else{ie===0&&(n.setRenderTarget(k.map),n.clear());let K=k.getViewport(ie);o.set(r.x*K.x,r.y*K.y,r.x*K.z,r.y*K.w),I.viewport(o)}i=k.getFrustum(ie),b(g,T,ne,Y,q,this.type)}k.isPointLightShadow!==!0&&this.type===da&&_(k,T),k.needsUpdate=!1}m=this.type,p.needsUpdate=!1,n.setRenderTarget(L,P,D)};function _(w,g){let T=e.update(y);f.defines.VSM_SAMPLES!==w.blurSamples&&(f.defines.VSM_SAMPLES=w.blurSamples,d.defines.VSM_SAMPLES=w.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),w.mapPass===null?w.mapPass=new Ci(s.x,s.y,{format:Ar,type:ns}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),f.uniforms.shadow_pass.value=w.map.depthTexture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,n.setRenderTarget(w.mapPass),n.clear(),n.renderBufferDirect(g,null,T,f,y,null),d.uniforms.shadow_pass.value=w.mapPass.texture,d.uniforms.resolution.value.set(w.map.width,w.map.height),d.uniforms.radius.value=w.radius,n.setRenderTarget(w.map),n.clear(),n.renderBufferDirect(g,null,T,d,y,null)}function S(w,g,T,L){let P=null,D=T.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(D!==void 0)P=D;else if(P=T.isPointLight===!0?l:a,n.localClippingEnabled&&g.clipShadows===!0&&Array.isArray(g.clippingPlanes)&&g.clippingPlanes.length!==0||g.displacementMap&&g.displacementScale!==0||g.alphaMap&&g.alphaTest>0||g.map&&g.alphaTest>0||g.alphaToCoverage===!0){let I=P.uuid,U=g.uuid,N=c[I];N===void 0&&(N={},c[I]=N);let G=N[U];G===void 0&&(G=P.clone(),N[U]=G,g.addEventListener("dispose",M)),P=G}if(P.visible=g.visible,P.wireframe=g.wireframe,L===da?P.side=g.shadowSide!==null?g.shadowSide:g.side:P.side=g.shadowSide!==null?g.shadowSide:h[g.side],P.alphaMap=g.alphaMap,P.alphaTest=g.alphaToCoverage===!0?.5:g.alphaTest,P.map=g.map,P.clipShadows=g.clipShadows,P.clippingPlanes=g.clippingPlanes,P.clipIntersection=g.clipIntersection,P.displacementMap=g.displacementMap,P.displacementScale=g.displacementScale,P.displacementBias=g.displacementBias,P.wireframeLinewidth=g.wireframeLinewidth,P.linewidth=g.linewidth,T.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let I=n.properties.get(P);I.light=T}return P}function b(w,g,T,L,P,D){if(w.visible===!1)return;if(w.layers.test(P)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&D===da)&&(!w.frustumCulled||w.intersectsFrustum(i))){w.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,w.matrixWorld);let N=e.update(w),G=w.material;if(Array.isArray(G)){let Y=N.groups;for(let k=0,se=Y.length;k<se;k++){let $=Y[k],Z=G[$.materialIndex];if(Z&&Z.visible){let q=S(w,Z,L,D);w.onBeforeShadow(n,w,g,T,N,q,$),n.renderBufferDirect(T,null,N,q,w,$),w.onAfterShadow(n,w,g,T,N,q,$)}}}else if(G.visible){let Y=S(w,G,L,D);w.onBeforeShadow(n,w,g,T,N,Y,null),n.renderBufferDirect(T,null,N,Y,w,null),w.onAfterShadow(n,w,g,T,N,Y,null)}}let U=w.children;for(let N=0,G=U.length;N<G;N++)b(U[N],g,T,L,P,D)}function M(w){w.target.removeEventListener("dispose",M);for(let T in c){let L=c[T],P=w.target.uuid;P in L&&(L[P].dispose(),delete L[P])}}}function kE(n,e){function t(){let z=!1,le=new kt,oe=null,Ae=new kt(0,0,0,0);return{setMask:function(ye){oe!==ye&&!z&&(n.colorMask(ye,ye,ye,ye),oe=ye)},setLocked:function(ye){z=ye},setClear:function(ye,we,Xe,Ke,fe){fe===!0&&(ye*=Ke,we*=Ke,Xe*=Ke),le.set(ye,we,Xe,Ke),Ae.equals(le)===!1&&(n.clearColor(ye,we,Xe,Ke),Ae.copy(le))},reset:function(){z=!1,oe=null,Ae.set(-1,0,0,0)}}}function i(){let z=!1,le=!1,oe=null,Ae=null,ye=null;return{setReversed:function(we){if(le!==we){let Xe=e.get("EXT_clip_control");we?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),le=we;let Ke=ye;ye=null,this.setClear(Ke)}},getReversed:function(){return le},setTest:function(we){we?ve(n.DEPTH_TEST):He(n.DEPTH_TEST)},setMask:function(we){oe!==we&&!z&&(n.depthMask(we),oe=we)},setFunc:function(we){if(le&&(we=bx[we]),Ae!==we){switch(we){case ou:n.depthFunc(n.NEVER);break;case au:n.depthFunc(n.ALWAYS);break;case lu:n.depthFunc(n.LESS);break;case na:n.depthFunc(n.LEQUAL);break;case cu:n.depthFunc(n.EQUAL);break;case uu:n.depthFunc(n.GEQUAL);break;case hu:n.depthFunc(n.GREATER);break;case fu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ae=we}},setLocked:function(we){z=we},setClear:function(we){ye!==we&&(ye=we,le&&(we=1-we),n.clearDepth(we))},reset:function(){z=!1,oe=null,Ae=null,ye=null,le=!1}}}function s(){let z=!1,le=null,oe=null,Ae=null,ye=null,we=null,Xe=null,Ke=null,fe=null;return{setTest:function(ke){z||(ke?ve(n.STENCIL_TEST):He(n.STENCIL_TEST))},setMask:function(ke){le!==ke&&!z&&(n.stencilMask(ke),le=ke)},setFunc:function(ke,Qe,Pe){(oe!==ke||Ae!==Qe||ye!==Pe)&&(n.stencilFunc(ke,Qe,Pe),oe=ke,Ae=Qe,ye=Pe)},setOp:function(ke,Qe,Pe){(we!==ke||Xe!==Qe||Ke!==Pe)&&(n.stencilOp(ke,Qe,Pe),we=ke,Xe=Qe,Ke=Pe)},setLocked:function(ke){z=ke},setClear:function(ke){fe!==ke&&(n.clearStencil(ke),fe=ke)},reset:function(){z=!1,le=null,oe=null,Ae=null,ye=null,we=null,Xe=null,Ke=null,fe=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},f={},d=new WeakMap,x=[],y=null,p=!1,m=null,_=null,S=null,b=null,M=null,w=null,g=null,T=new it(0,0,0),L=0,P=!1,D=null,I=null,U=null,N=null,G=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),k=!1,se=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(se=parseFloat(/^WebGL (\d)/.exec($)[1]),k=se>=1):$.indexOf("OpenGL ES")!==-1&&(se=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),k=se>=2);let Z=null,q={},ie=n.getParameter(n.SCISSOR_BOX),ne=n.getParameter(n.VIEWPORT),K=new kt().fromArray(ie),he=new kt().fromArray(ne);function me(z,le,oe,Ae){let ye=new Uint8Array(4),we=n.createTexture();n.bindTexture(z,we),n.texParameteri(z,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(z,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Xe=0;Xe<oe;Xe++)z===n.TEXTURE_3D||z===n.TEXTURE_2D_ARRAY?n.texImage3D(le,0,n.RGBA,1,1,Ae,0,n.RGBA,n.UNSIGNED_BYTE,ye):n.texImage2D(le+Xe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ye);return we}let xe={};xe[n.TEXTURE_2D]=me(n.TEXTURE_2D,n.TEXTURE_2D,1),xe[n.TEXTURE_CUBE_MAP]=me(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),xe[n.TEXTURE_2D_ARRAY]=me(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),xe[n.TEXTURE_3D]=me(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ve(n.DEPTH_TEST),o.setFunc(na),dn(!1),Ut(Vd),ve(n.CULL_FACE),Qt(to);function ve(z){u[z]!==!0&&(n.enable(z),u[z]=!0)}function He(z){u[z]!==!1&&(n.disable(z),u[z]=!1)}function ot(z,le){return f[z]!==le?(n.bindFramebuffer(z,le),f[z]=le,z===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=le),z===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=le),!0):!1}function We(z,le){let oe=x,Ae=!1;if(z){oe=d.get(le),oe===void 0&&(oe=[],d.set(le,oe));let ye=z.textures;if(oe.length!==ye.length||oe[0]!==n.COLOR_ATTACHMENT0){for(let we=0,Xe=ye.length;we<Xe;we++)oe[we]=n.COLOR_ATTACHMENT0+we;oe.length=ye.length,Ae=!0}}else oe[0]!==n.BACK&&(oe[0]=n.BACK,Ae=!0);Ae&&n.drawBuffers(oe)}function ft(z){return y!==z?(n.useProgram(z),y=z,!0):!1}let ct={[no]:n.FUNC_ADD,[H_]:n.FUNC_SUBTRACT,[W_]:n.FUNC_REVERSE_SUBTRACT};ct[X_]=n.MIN,ct[q_]=n.MAX;let st={[$_]:n.ZERO,[Y_]:n.ONE,[J_]:n.SRC_COLOR,[Xd]:n.SRC_ALPHA,[tx]:n.SRC_ALPHA_SATURATE,[Q_]:n.DST_COLOR,[Z_]:n.DST_ALPHA,[j_]:n.ONE_MINUS_SRC_COLOR,[qd]:n.ONE_MINUS_SRC_ALPHA,[ex]:n.ONE_MINUS_DST_COLOR,[K_]:n.ONE_MINUS_DST_ALPHA,[nx]:n.CONSTANT_COLOR,[ix]:n.ONE_MINUS_CONSTANT_COLOR,[sx]:n.CONSTANT_ALPHA,[rx]:n.ONE_MINUS_CONSTANT_ALPHA};function Qt(z,le,oe,Ae,ye,we,Xe,Ke,fe,ke){if(z===to){p===!0&&(He(n.BLEND),p=!1);return}if(p===!1&&(ve(n.BLEND),p=!0),z!==G_){if(z!==m||ke!==P){if((_!==no||M!==no)&&(n.blendEquation(n.FUNC_ADD),_=no,M=no),ke)switch(z){case pa:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Gd:n.blendFunc(n.ONE,n.ONE);break;case Hd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Wd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:et("WebGLState: Invalid blending: ",z);break}else switch(z){case pa:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Gd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Hd:et("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Wd:et("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:et("WebGLState: Invalid blending: ",z);break}S=null,b=null,w=null,g=null,T.set(0,0,0),L=0,m=z,P=ke}return}ye=ye||le,we=we||oe,Xe=Xe||Ae,(le!==_||ye!==M)&&(n.blendEquationSeparate(ct[le],ct[ye]),_=le,M=ye),(oe!==S||Ae!==b||we!==w||Xe!==g)&&(n.blendFuncSeparate(st[oe],st[Ae],st[we],st[Xe]),S=oe,b=Ae,w=we,g=Xe),(Ke.equals(T)===!1||fe!==L)&&(n.blendColor(Ke.r,Ke.g,Ke.b,fe),T.copy(Ke),L=fe),m=z,P=!1}function Wt(z,le){z.side===di?He(n.CULL_FACE):ve(n.CULL_FACE);let oe=z.side===ui;le&&(oe=!oe),dn(oe),z.blending===pa&&z.transparent===!1?Qt(to):Qt(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let Ae=z.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),St(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?ve(n.SAMPLE_ALPHA_TO_COVERAGE):He(n.SAMPLE_ALPHA_TO_COVERAGE)}function dn(z){D!==z&&(z?n.frontFace(n.CW):n.frontFace(n.CCW),D=z)}function Ut(z){z!==k_?(ve(n.CULL_FACE),z!==I&&(z===Vd?n.cullFace(n.BACK):z===z_?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):He(n.CULL_FACE),I=z}function In(z){z!==U&&(k&&n.lineWidth(z),U=z)}function St(z,le,oe){z?(ve(n.POLYGON_OFFSET_FILL),(N!==le||G!==oe)&&(N=le,G=oe,o.getReversed()&&(le=-le,oe=-oe),n.polygonOffset(le,oe))):He(n.POLYGON_OFFSET_FILL)}function wn(z){z?ve(n.SCISSOR_TEST):He(n.SCISSOR_TEST)}function sn(z){z===void 0&&(z=n.TEXTURE0+Y-1),Z!==z&&(n.activeTexture(z),Z=z)}function pn(z,le,oe){oe===void 0&&(Z===null?oe=n.TEXTURE0+Y-1:oe=Z);let Ae=q[oe];Ae===void 0&&(Ae={type:void 0,texture:void 0},q[oe]=Ae),(Ae.type!==z||Ae.texture!==le)&&(Z!==oe&&(n.activeTexture(oe),Z=oe),n.bindTexture(z,le||xe[z]),Ae.type=z,Ae.texture=le)}function V(){let z=q[Z];z!==void 0&&z.type!==void 0&&(n.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function Ie(){try{n.compressedTexImage2D(...arguments)}catch(z){et("WebGLState:",z)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(z){et("WebGLState:",z)}}function at(){try{n.texSubImage2D(...arguments)}catch(z){et("WebGLState:",z)}}function Te(){try{n.texSubImage3D(...arguments)}catch(z){et("WebGLState:",z)}}function zt(){try{n.compressedTexSubImage2D(...arguments)}catch(z){et("WebGLState:",z)}}function Ge(){try{n.compressedTexSubImage3D(...arguments)}catch(z){et("WebGLState:",z)}}function $e(){try{n.texStorage2D(...arguments)}catch(z){et("WebGLState:",z)}}function O(){try{n.texStorage3D(...arguments)}catch(z){et("WebGLState:",z)}}function E(){try{n.texImage2D(...arguments)}catch(z){et("WebGLState:",z)}}function J(){try{n.texImage3D(...arguments)}catch(z){et("WebGLState:",z)}}function de(z){return h[z]!==void 0?h[z]:n.getParameter(z)}function ce(z,le){h[z]!==le&&(n.pixelStorei(z,le),h[z]=le)}function be(z){K.equals(z)===!1&&(n.scissor(z.x,z.y,z.z,z.w),K.copy(z))}function Se(z){he.equals(z)===!1&&(n.viewport(z.x,z.y,z.z,z.w),he.copy(z))}function re(z,le){let oe=c.get(le);oe===void 0&&(oe=new WeakMap,c.set(le,oe));let Ae=oe.get(z);Ae===void 0&&(Ae=n.getUniformBlockIndex(le,z.name),n.uniformBlockBinding(le,Ae,Ae),oe.set(z,Ae))}function ae(z,le,oe){let ye=c.get(le).get(z);l[ye]!==oe&&(n.bindBufferBase(n.UNIFORM_BUFFER,ye,oe),l[ye]=oe)}function _e(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Z=null,q={},f={},l={},d=new WeakMap,x=[],y=null,p=!1,m=null,_=null,S=null,b=null,M=null,w=null,g=null,T=new it(0,0,0),L=0,P=!1,D=null,I=null,U=null,N=null,G=null,K.set(0,0,n.canvas.width,n.canvas.height),he.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ve,disable:He,bindFramebuffer:ot,drawBuffers:We,useProgram:ft,setBlending:Qt,setMaterial:Wt,setFlipSided:dn,setCullFace:Ut,setLineWidth:In,setPolygonOffset:St,setScissorTest:wn,activeTexture:sn,bindTexture:pn,unbindTexture:V,compressedTexImage2D:Ie,compressedTexImage3D:Je,texImage2D:E,texImage3D:J,pixelStorei:ce,getParameter:de,updateUBOMapping:re,uniformBlockBinding:ae,texStorage2D:$e,texStorage3D:O,texSubImage2D:at,texSubImage3D:Te,compressedTexSubImage2D:zt,compressedTexSubImage3D:Ge,scissor:be,viewport:Se,reset:_e}}function zE(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ze,u=new WeakMap,h=new Set,f,d=new WeakMap,x=new Set,y=new FinalizationRegistry(O=>x.delete(O)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(O,E){return p?new OffscreenCanvas(O,E):cl("canvas")}function _(O,E,J){let de=1,ce=$e(O);if((ce.width>J||ce.height>J)&&(de=J/Math.max(ce.width,ce.height)),de<1)if(typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&O instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&O instanceof ImageBitmap||typeof VideoFrame<"u"&&O instanceof VideoFrame){let be=Math.floor(de*ce.width),Se=Math.floor(de*ce.height);f===void 0&&(f=m(be,Se));let re=E?m(be,Se):f;return re.width=be,re.height=Se,re.getContext("2d").drawImage(O,0,0,be,Se),Ye("WebGLRenderer: Texture has been resized from ("+ce.width+"x"+ce.height+") to ("+be+"x"+Se+")."),re}else return"data"in O&&Ye("WebGLRenderer: Image in DataTexture is too big ("+ce.width+"x"+ce.height+")."),O;return O}function S(O){return O.generateMipmaps}function b(O){n.generateMipmap(O)}function M(O){return O.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:O.isWebGL3DRenderTarget?n.TEXTURE_3D:O.isWebGLArrayRenderTarget||O.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function w(O,E,J,de,ce,be=!1){if(O!==null){if(n[O]!==void 0)return n[O];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+O+"'")}let Se;de&&(Se=e.get("EXT_texture_norm16"),Se||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let re=E;if(E===n.RED&&(J===n.FLOAT&&(re=n.R32F),J===n.HALF_FLOAT&&(re=n.R16F),J===n.UNSIGNED_BYTE&&(re=n.R8),J===n.UNSIGNED_SHORT&&Se&&(re=Se.R16_EXT),J===n.SHORT&&Se&&(re=Se.R16_SNORM_EXT)),E===n.RED_INTEGER&&(J===n.UNSIGNED_BYTE&&(re=n.R8UI),J===n.UNSIGNED_SHORT&&(re=n.R16UI),J===n.UNSIGNED_INT&&(re=n.R32UI),J===n.BYTE&&(re=n.R8I),J===n.SHORT&&(re=n.R16I),J===n.INT&&(re=n.R32I)),E===n.RG&&(J===n.FLOAT&&(re=n.RG32F),J===n.HALF_FLOAT&&(re=n.RG16F),J===n.UNSIGNED_BYTE&&(re=n.RG8),J===n.UNSIGNED_SHORT&&Se&&(re=Se.RG16_EXT),J===n.SHORT&&Se&&(re=Se.RG16_SNORM_EXT)),E===n.RG_INTEGER&&(J===n.UNSIGNED_BYTE&&(re=n.RG8UI),J===n.UNSIGNED_SHORT&&(re=n.RG16UI),J===n.UNSIGNED_INT&&(re=n.RG32UI),J===n.BYTE&&(re=n.RG8I),J===n.SHORT&&(re=n.RG16I),J===n.INT&&(re=n.RG32I)),E===n.RGB_INTEGER&&(J===n.UNSIGNED_BYTE&&(re=n.RGB8UI),J===n.UNSIGNED_SHORT&&(re=n.RGB16UI),J===n.UNSIGNED_INT&&(re=n.RGB32UI),J===n.BYTE&&(re=n.RGB8I),J===n.SHORT&&(re=n.RGB16I),J===n.INT&&(re=n.RGB32I)),E===n.RGBA_INTEGER&&(J===n.UNSIGNED_BYTE&&(re=n.RGBA8UI),J===n.UNSIGNED_SHORT&&(re=n.RGBA16UI),J===n.UNSIGNED_INT&&(re=n.RGBA32UI),J===n.BYTE&&(re=n.RGBA8I),J===n.SHORT&&(re=n.RGBA16I),J===n.INT&&(re=n.RGBA32I)),E===n.RGB&&(J===n.UNSIGNED_SHORT&&Se&&(re=Se.RGB16_EXT),J===n.SHORT&&Se&&(re=Se.RGB16_SNORM_EXT),J===n.UNSIGNED_INT_5_9_9_9_REV&&(re=n.RGB9_E5),J===n.UNSIGNED_INT_10F_11F_11F_REV&&(re=n.R11F_G11F_B10F)),E===n.RGBA){let ae=be?ll:yt.getTransfer(ce);J===n.FLOAT&&(re=n.RGBA32F),J===n.HALF_FLOAT&&(re=n.RGBA16F),J===n.UNSIGNED_BYTE&&(re=ae===Pt?n.SRGB8_ALPHA8:n.RGBA8),J===n.UNSIGNED_SHORT&&Se&&(re=Se.RGBA16_EXT),J===n.SHORT&&Se&&(re=Se.RGBA16_SNORM_EXT),J===n.UNSIGNED_SHORT_4_4_4_4&&(re=n.RGBA4),J===n.UNSIGNED_SHORT_5_5_5_1&&(re=n.RGB5_A1)}return(re===n.R16F||re===n.R32F||re===n.RG16F||re===n.RG32F||re===n.RGBA16F||re===n.RGBA32F)&&e.get("EXT_color_buffer_float"),re}function g(O,E){let J;return O?E===null||E===ts||E===so?J=n.DEPTH24_STENCIL8:E===Vi?J=n.DEPTH32F_STENCIL8:E===ga&&(J=n.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===ts||E===so?J=n.DEPTH_COMPONENT24:E===Vi?J=n.DEPTH_COMPONENT32F:E===ga&&(J=n.DEPTH_COMPONENT16),J}function T(O,E){return S(O)===!0||O.isFramebufferTexture&&O.minFilter!==Bn&&O.minFilter!==ci?Math.log2(Math.max(E.width,E.height))+1:O.mipmaps.length>0?O.mipmaps.length:O.isCompressedTexture&&Array.isArray(O.image)?E.mipmaps.length:1}function L(O){let E=new WeakRef(O);i.get(O).__ref=E,x.add(E),y.register(O,E,E)}function P(O){let E=i.get(O).__ref;E!==void 0&&(x.delete(E),y.unregister(E))}function D(O){U(O.target)}function I(O){N(O.target)}function U(O){O.removeEventListener("dispose",D),P(O),Y(O),O.isVideoTexture&&u.delete(O),O.isHTMLTexture&&h.delete(O)}function N(O){O.removeEventListener("dispose",I),P(O),se(O)}function G(){for(let O of x){let E=O.deref();E!==void 0&&(E.isRenderTarget===!0?N(E):U(E))}x.clear(),h.clear()}function Y(O){let E=i.get(O);if(E.__webglInit===void 0)return;let J=O.source,de=d.get(J);if(de){let ce=de[E.__cacheKey];ce.usedTimes--,ce.usedTimes===0&&k(O),Object.keys(de).length===0&&d.delete(J)}i.remove(O)}function k(O){let E=i.get(O);n.deleteTexture(E.__webglTexture);let J=O.source,de=d.get(J);delete de[E.__cacheKey],o.memory.textures--}function se(O){let E=i.get(O);E.__depthDisposeCallback&&E.__depthDisposeCallback();let J=O.depthTexture;if(J&&J.renderTarget===O&&U(J),O.isWebGLCubeRenderTarget)for(let ce=0;ce<6;ce++){if(Array.isArray(E.__webglFramebuffer[ce]))for(let be=0;be<E.__webglFramebuffer[ce].length;be++)n.deleteFramebuffer(E.__webglFramebuffer[ce][be]);else n.deleteFramebuffer(E.__webglFramebuffer[ce]);E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer[ce])}else{if(Array.isArray(E.__webglFramebuffer))for(let ce=0;ce<E.__webglFramebuffer.length;ce++)n.deleteFramebuffer(E.__webglFramebuffer[ce]);else n.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&n.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let ce=0;ce<E.__webglColorRenderbuffer.length;ce++)E.__webglColorRenderbuffer[ce]&&n.deleteRenderbuffer(E.__webglColorRenderbuffer[ce]);E.__webglDepthRenderbuffer&&n.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let de=O.textures;for(let ce=0,be=de.length;ce<be;ce++){let Se=i.get(de[ce]);Se.__webglTexture&&(n.deleteTexture(Se.__webglTexture),o.memory.textures--),i.remove(de[ce])}i.remove(O)}let $=0;function Z(){$=0}function q(){return $}function ie(O){$=O}function ne(){let O=$;return O>=s.maxTextures&&Ye("WebGLTextures: Trying to use "+(O+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,O}function K(O){let E=[];return E.push(O.wrapS),E.push(O.wrapT),E.push(O.wrapR||0),E.push(O.magFilter),E.push(O.minFilter),E.push(O.anisotropy),E.push(O.internalFormat),E.push(O.format),E.push(O.type),E.push(O.generateMipmaps),E.push(O.mipmapsAutoUpdate),E.push(O.premultiplyAlpha),E.push(O.flipY),E.push(O.unpackAlignment),E.push(O.colorSpace),E.join()}function he(O,E){let J=i.get(O);if(O.isVideoTexture&&zt(O),O.isRenderTargetTexture===!1&&O.isExternalTexture!==!0&&O.version>0&&J.__version!==O.version){let de=O.image;if(de===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(de.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{Wt(J,O,E);return}}else O.isExternalTexture&&(J.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,J.__webglTexture,n.TEXTURE0+E)}function me(O,E){let J=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&J.__version!==O.version){Wt(J,O,E);return}else O.isExternalTexture&&(J.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,J.__webglTexture,n.TEXTURE0+E)}function xe(O,E){let J=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&J.__version!==O.version){Wt(J,O,E);return}t.bindTexture(n.TEXTURE_3D,J.__webglTexture,n.TEXTURE0+E)}function ve(O,E){let J=i.get(O);if(O.version>0&&J.__version!==O.version){dn(J,O,E);return}t.bindTexture(n.TEXTURE_CUBE_MAP,J.__webglTexture,n.TEXTURE0+E)}let He={[du]:n.REPEAT,[gs]:n.CLAMP_TO_EDGE,[pu]:n.MIRRORED_REPEAT},ot={[Bn]:n.NEAREST,[lx]:n.NEAREST_MIPMAP_NEAREST,[Il]:n.NEAREST_MIPMAP_LINEAR,[ci]:n.LINEAR,[zu]:n.LINEAR_MIPMAP_NEAREST,[Js]:n.LINEAR_MIPMAP_LINEAR},We={[fx]:n.NEVER,[cp]:n.ALWAYS,[dx]:n.LESS,[ap]:n.LEQUAL,[px]:n.EQUAL,[lp]:n.GEQUAL,[mx]:n.GREATER,[gx]:n.NOTEQUAL};function ft(O,E){if(E.type===Vi&&e.has("OES_texture_float_linear")===!1&&(E.magFilter===ci||E.magFilter===zu||E.magFilter===Il||E.magFilter===Js||E.minFilter===ci||E.minFilter===zu||E.minFilter===Il||E.minFilter===Js)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(O,n.TEXTURE_WRAP_S,He[E.wrapS]),n.texParameteri(O,n.TEXTURE_WRAP_T,He[E.wrapT]),(O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY)&&n.texParameteri(O,n.TEXTURE_WRAP_R,He[E.wrapR]),n.texParameteri(O,n.TEXTURE_MAG_FILTER,ot[E.magFilter]),n.texParameteri(O,n.TEXTURE_MIN_FILTER,ot[E.minFilter]),E.compareFunction&&(n.texParameteri(O,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(O,n.TEXTURE_COMPARE_FUNC,We[E.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Bn||E.minFilter!==Il&&E.minFilter!==Js||E.type===Vi&&e.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||i.get(E).__currentAnisotropy){let J=e.get("EXT_texture_filter_anisotropic");n.texParameterf(O,J.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),i.get(E).__currentAnisotropy=E.anisotropy}}}function ct(O,E){let J=!1;O.__webglInit===void 0&&(O.__webglInit=!0,E.addEventListener("dispose",D),L(E));let de=E.source,ce=d.get(de);ce===void 0&&(ce={},d.set(de,ce));let be=K(E);if(be!==O.__cacheKey){ce[be]===void 0&&(ce[be]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,J=!0),ce[be].usedTimes++;let Se=ce[O.__cacheKey];Se!==void 0&&(ce[O.__cacheKey].usedTimes--,Se.usedTimes===0&&k(E)),O.__cacheKey=be,O.__webglTexture=ce[be].texture}return J}function st(O,E,J){return Math.floor(Math.floor(O/J)/E)}function Qt(O,E,J,de){let be=O.updateRanges;if(be.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,E.width,E.height,J,de,E.data);else{be.sort((z,le)=>z.start-le.start);let Se=0;for(let z=1;z<be.length;z++){let le=be[Se],oe=be[z],Ae=le.start+le.count,ye=st(oe.start,E.width,4),we=st(le.start,E.width,4);oe.start<=Ae+1&&ye===we&&st(oe.start+oe.count-1,E.width,4)===ye?le.count=Math.max(le.count,oe.start+oe.count-le.start):(++Se,be[Se]=oe)}be.length=Se+1;let re=t.getParameter(n.UNPACK_ROW_LENGTH),ae=t.getParameter(n.UNPACK_SKIP_PIXELS),_e=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,E.width);for(let z=0,le=be.length;z<le;z++){let oe=be[z],Ae=Math.floor(oe.start/4),ye=Math.ceil(oe.count/4),we=Ae%E.width,Xe=Math.floor(Ae/E.width),Ke=ye,fe=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,we),t.pixelStorei(n.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(n.TEXTURE_2D,0,we,Xe,Ke,fe,J,de,E.data)}O.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,re),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ae),t.pixelStorei(n.UNPACK_SKIP_ROWS,_e)}}function Wt(O,E,J){let de=n.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(de=n.TEXTURE_2D_ARRAY),E.isData3DTexture&&(de=n.TEXTURE_3D);let ce=ct(O,E),be=E.source;t.bindTexture(de,O.__webglTexture,n.TEXTURE0+J);let Se=i.get(be);if(be.version!==Se.__version||ce===!0){if(t.activeTexture(n.TEXTURE0+J),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let fe=yt.getPrimaries(yt.workingColorSpace),ke=E.colorSpace===Zs?null:yt.getPrimaries(E.colorSpace),Qe=E.colorSpace===Zs||fe===ke?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Qe)}t.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment);let ae=_(E.image,!1,s.maxTextureSize);ae=Ge(E,ae);let _e=r.convert(E.format,E.colorSpace),z=r.convert(E.type),le=w(E.internalFormat,_e,z,E.normalized,E.colorSpace,E.isVideoTexture);ft(de,E);let oe,Ae=E.mipmaps,ye=E.isVideoTexture!==!0,we=Se.__version===void 0||ce===!0,Xe=be.dataReady,Ke=T(E,ae);if(E.isDepthTexture)le=g(E.format===js,E.type),we&&(ye?t.texStorage2D(n.TEXTURE_2D,1,le,ae.width,ae.height):t.texImage2D(n.TEXTURE_2D,0,le,ae.width,ae.height,0,_e,z,null));else if(E.isDataTexture)if(Ae.length>0){ye&&we&&t.texStorage2D(n.TEXTURE_2D,Ke,le,Ae[0].width,Ae[0].height);for(let fe=0,ke=Ae.length;fe<ke;fe++)oe=Ae[fe],ye?Xe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,oe.width,oe.height,_e,z,oe.data):t.texImage2D(n.TEXTURE_2D,fe,le,oe.width,oe.height,0,_e,z,oe.data);E.generateMipmaps=!1}else ye?(we&&t.texStorage2D(n.TEXTURE_2D,Ke,le,ae.width,ae.height),Xe&&Qt(E,ae,_e,z)):t.texImage2D(n.TEXTURE_2D,0,le,ae.width,ae.height,0,_e,z,ae.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){ye&&we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ke,le,Ae[0].width,Ae[0].height,ae.depth);for(let fe=0,ke=Ae.length;fe<ke;fe++)if(oe=Ae[fe],E.format!==is)if(_e!==null)if(ye){if(Xe)if(E.layerUpdates.size>0){let Qe=xp(oe.width,oe.height,E.format,E.type);for(let Pe of E.layerUpdates){let lt=oe.data.subarray(Pe*Qe/oe.data.BYTES_PER_ELEMENT,(Pe+1)*Qe/oe.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,Pe,oe.width,oe.height,1,_e,lt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,0,oe.width,oe.height,ae.depth,_e,oe.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,fe,le,oe.width,oe.height,ae.depth,0,oe.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?Xe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,0,oe.width,oe.height,ae.depth,_e,z,oe.data):t.texImage3D(n.TEXTURE_2D_ARRAY,fe,le,oe.width,oe.height,ae.depth,0,_e,z,oe.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{ye&&we&&t.texStorage2D(n.TEXTURE_2D,Ke,le,Ae[0].width,Ae[0].height);for(let fe=0,ke=Ae.length;fe<ke;fe++)oe=Ae[fe],E.format!==is?_e!==null?ye?Xe&&t.compressedTexSubImage2D(n.TEXTURE_2D,fe,0,0,oe.width,oe.height,_e,oe.data):t.compressedTexImage2D(n.TEXTURE_2D,fe,le,oe.width,oe.height,0,oe.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?Xe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,oe.width,oe.height,_e,z,oe.data):t.texImage2D(n.TEXTURE_2D,fe,le,oe.width,oe.height,0,_e,z,oe.data)}else if(E.isDataArrayTexture)if(ye){if(we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ke,le,ae.width,ae.height,ae.depth),Xe)if(E.layerUpdates.size>0){let fe=xp(ae.width,ae.height,E.format,E.type);for(let ke of E.layerUpdates){let Qe=ae.data.subarray(ke*fe/ae.data.BYTES_PER_ELEMENT,(ke+1)*fe/ae.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ke,ae.width,ae.height,1,_e,z,Qe)}E.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ae.width,ae.height,ae.depth,_e,z,ae.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,le,ae.width,ae.height,ae.depth,0,_e,z,ae.data);else if(E.isData3DTexture)ye?(we&&t.texStorage3D(n.TEXTURE_3D,Ke,le,ae.width,ae.height,ae.depth),Xe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ae.width,ae.height,ae.depth,_e,z,ae.data)):t.texImage3D(n.TEXTURE_3D,0,le,ae.width,ae.height,ae.depth,0,_e,z,ae.data);else if(E.isFramebufferTexture){if(we)if(ye)t.texStorage2D(n.TEXTURE_2D,Ke,le,ae.width,ae.height);else{let fe=ae.width,ke=ae.height;for(let Qe=0;Qe<Ke;Qe++)t.texImage2D(n.TEXTURE_2D,Qe,le,fe,ke,0,_e,z,null),fe>>=1,ke>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in n){let fe=n.canvas;if(fe.hasAttribute("layoutsubtree")||fe.setAttribute("layoutsubtree","true"),ae.parentNode!==fe){fe.appendChild(ae),h.add(E),fe.onpaint=ke=>{let Qe=ke.changedElements;for(let Pe of h)Qe.includes(Pe.image)&&(Pe.needsUpdate=!0)},fe.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ae);else{let Qe=n.RGBA,Pe=n.RGBA,lt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Qe,Pe,lt,ae)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(ye&&we){let fe=$e(Ae[0]);t.texStorage2D(n.TEXTURE_2D,Ke,le,fe.width,fe.height)}for(let fe=0,ke=Ae.length;fe<ke;fe++)oe=Ae[fe],ye?Xe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,_e,z,oe):t.texImage2D(n.TEXTURE_2D,fe,le,_e,z,oe);E.generateMipmaps=!1}else if(ye){if(we){let fe=$e(ae);t.texStorage2D(n.TEXTURE_2D,Ke,le,fe.width,fe.height)}Xe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,_e,z,ae)}else t.texImage2D(n.TEXTURE_2D,0,le,_e,z,ae);S(E)&&E.mipmapsAutoUpdate===!0&&b(de),Se.__version=be.version,E.onUpdate&&E.onUpdate(E)}O.__version=E.version}function dn(O,E,J){if(E.image.length!==6)return;let de=ct(O,E),ce=E.source;t.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+J);let be=i.get(ce);if(ce.version!==be.__version||de===!0){t.activeTexture(n.TEXTURE0+J);let Se=yt.getPrimaries(yt.workingColorSpace),re=E.colorSpace===Zs?null:yt.getPrimaries(E.colorSpace),ae=E.colorSpace===Zs||Se===re?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ae);let _e=E.isCompressedTexture||E.image[0].isCompressedTexture,z=E.image[0]&&E.image[0].isDataTexture,le=[];for(let Pe=0;Pe<6;Pe++)!_e&&!z?le[Pe]=_(E.image[Pe],!0,s.maxCubemapSize):le[Pe]=z?E.image[Pe].image:E.image[Pe],le[Pe]=Ge(E,le[Pe]);let oe=le[0],Ae=r.convert(E.format,E.colorSpace),ye=r.convert(E.type),we=w(E.internalFormat,Ae,ye,E.normalized,E.colorSpace),Xe=E.isVideoTexture!==!0,Ke=be.__version===void 0||de===!0,fe=ce.dataReady,ke=T(E,oe);ft(n.TEXTURE_CUBE_MAP,E);let Qe;if(E.isDepthTexture){if(we=g(E.format===js,E.type),Ke)if(Xe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,we,oe.width,oe.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,we,oe.width,oe.height,0,Ae,ye,null)}else if(_e){Xe&&Ke&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,we,oe.width,oe.height);for(let Pe=0;Pe<6;Pe++){Qe=le[Pe].mipmaps;for(let lt=0;lt<Qe.length;lt++){let Xt=Qe[lt];E.format!==is?Ae!==null?Xe?fe&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,0,0,Xt.width,Xt.height,Ae,Xt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,we,Xt.width,Xt.height,0,Xt.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,0,0,Xt.width,Xt.height,Ae,ye,Xt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,we,Xt.width,Xt.height,0,Ae,ye,Xt.data)}}}else{if(Qe=E.mipmaps,Xe&&Ke){Qe.length>0&&ke++;let Pe=$e(le[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,we,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(z){Xe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,le[Pe].width,le[Pe].height,Ae,ye,le[Pe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,we,le[Pe].width,le[Pe].height,0,Ae,ye,le[Pe].data);for(let lt=0;lt<Qe.length;lt++){let Kn=Qe[lt].image[Pe].image;Xe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,0,0,Kn.width,Kn.height,Ae,ye,Kn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,we,Kn.width,Kn.height,0,Ae,ye,Kn.data)}}else{Xe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Ae,ye,le[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,we,Ae,ye,le[Pe]);for(let lt=0;lt<Qe.length;lt++){let Xt=Qe[lt];Xe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,0,0,Ae,ye,Xt.image[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,we,Ae,ye,Xt.image[Pe])}}}S(E)&&E.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),be.__version=ce.version,E.onUpdate&&E.onUpdate(E)}O.__version=E.version}function Ut(O,E,J,de,ce,be){let Se=r.convert(J.format,J.colorSpace),re=r.convert(J.type),ae=w(J.internalFormat,Se,re,J.normalized,J.colorSpace),_e=i.get(E),z=i.get(J);if(z.__renderTarget=E,!_e.__hasExternalTextures){let le=Math.max(1,E.width>>be),oe=Math.max(1,E.height>>be);ce===n.TEXTURE_3D||ce===n.TEXTURE_2D_ARRAY?t.texImage3D(ce,be,ae,le,oe,E.depth,0,Se,re,null):t.texImage2D(ce,be,ae,le,oe,0,Se,re,null)}t.bindFramebuffer(n.FRAMEBUFFER,O),Te(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,de,ce,z.__webglTexture,0,at(E)):(ce===n.TEXTURE_2D||ce>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ce<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,de,ce,z.__webglTexture,be),t.bindFramebuffer(n.FRAMEBUFFER,null)}function In(O,E,J){if(n.bindRenderbuffer(n.RENDERBUFFER,O),E.depthBuffer){let de=E.depthTexture,ce=de&&de.isDepthTexture?de.type:null,be=g(E.stencilBuffer,ce),Se=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Te(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(E),be,E.width,E.height):J?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(E),be,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,be,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Se,n.RENDERBUFFER,O)}else{let de=E.textures;for(let ce=0;ce<de.length;ce++){let be=de[ce],Se=r.convert(be.format,be.colorSpace),re=r.convert(be.type),ae=w(be.internalFormat,Se,re,be.normalized,be.colorSpace);Te(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(E),ae,E.width,E.height):J?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(E),ae,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,ae,E.width,E.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function St(O,E,J){let de=E.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,O),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ce=i.get(E.depthTexture);ce.__renderTarget=E;let be=de?E.depthTexture.image[0]:E.depthTexture.image;(!ce.__webglTexture||be.width!==E.width||be.height!==E.height)&&(be.width=E.width,be.height=E.height,E.depthTexture.needsUpdate=!0),de?ve(E.depthTexture,0):he(E.depthTexture,0);let Se=ce.__webglTexture,re=at(E),ae=de?n.TEXTURE_CUBE_MAP_POSITIVE_X+J:n.TEXTURE_2D,_e=E.depthTexture.format===js?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(E.depthTexture.format===Gs)Te(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,_e,ae,Se,0,re):n.framebufferTexture2D(n.FRAMEBUFFER,_e,ae,Se,0);else if(E.depthTexture.format===js)Te(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,_e,ae,Se,0,re):n.framebufferTexture2D(n.FRAMEBUFFER,_e,ae,Se,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function wn(O){let E=i.get(O),J=O.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==O.depthTexture){let de=O.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),de){let ce=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,de.removeEventListener("dispose",ce)};de.addEventListener("dispose",ce),E.__depthDisposeCallback=ce}E.__boundDepthTexture=de}if(O.depthTexture&&!E.__autoAllocateDepthBuffer)if(J)for(let de=0;de<6;de++)St(E.__webglFramebuffer[de],O,de);else O.texture.mipmaps.length>0?St(E.__webglFramebuffer[0],O,0):St(E.__webglFramebuffer,O,0);else if(J){E.__webglDepthbuffer=[];for(let de=0;de<6;de++)if(t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[de]),E.__webglDepthbuffer[de]===void 0)E.__webglDepthbuffer[de]=n.createRenderbuffer(),In(E.__webglDepthbuffer[de],O,!1);else{let ce=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,be=E.__webglDepthbuffer[de];n.bindRenderbuffer(n.RENDERBUFFER,be),n.framebufferRenderbuffer(n.FRAMEBUFFER,ce,n.RENDERBUFFER,be)}}else if(O.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=n.createRenderbuffer(),In(E.__webglDepthbuffer,O,!1);else{let ce=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,be=E.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,be),n.framebufferRenderbuffer(n.FRAMEBUFFER,ce,n.RENDERBUFFER,be)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function sn(O,E,J){let de=i.get(O);E!==void 0&&Ut(de.__webglFramebuffer,O,O.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),J!==void 0&&wn(O)}function pn(O){let E=O.texture,J=i.get(O),de=i.get(E);O.addEventListener("dispose",I),L(O);let ce=O.textures,be=O.isWebGLCubeRenderTarget===!0,Se=ce.length>1;if(Se||(de.__webglTexture===void 0&&(de.__webglTexture=n.createTexture()),de.__version=E.version,o.memory.textures++),be){J.__webglFramebuffer=[];for(let re=0;re<6;re++)if(E.mipmaps.length>0){J.__webglFramebuffer[re]=[];for(let ae=0;ae<E.mipmaps.length;ae++)J.__webglFramebuffer[re][ae]=n.createFramebuffer()}else J.__webglFramebuffer[re]=n.createFramebuffer()}else{if(E.mipmaps.length>0){J.__webglFramebuffer=[];for(let re=0;re<E.mipmaps.length;re++)J.__webglFramebuffer[re]=n.createFramebuffer()}else J.__webglFramebuffer=n.createFramebuffer();if(Se)for(let re=0,ae=ce.length;re<ae;re++){let _e=i.get(ce[re]);_e.__webglTexture===void 0&&(_e.__webglTexture=n.createTexture(),o.memory.textures++)}if(O.samples>0&&Te(O)===!1){J.__webglMultisampledFramebuffer=n.createFramebuffer(),J.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,J.__webglMultisampledFramebuffer);for(let re=0;re<ce.length;re++){let ae=ce[re];J.__webglColorRenderbuffer[re]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,J.__webglColorRenderbuffer[re]);let _e=r.convert(ae.format,ae.colorSpace),z=r.convert(ae.type),le=w(ae.internalFormat,_e,z,ae.normalized,ae.colorSpace,O.isXRRenderTarget===!0),oe=at(O);n.renderbufferStorageMultisample(n.RENDERBUFFER,oe,le,O.width,O.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+re,n.RENDERBUFFER,J.__webglColorRenderbuffer[re])}n.bindRenderbuffer(n.RENDERBUFFER,null),O.depthBuffer&&(J.__webglDepthRenderbuffer=n.createRenderbuffer(),In(J.__webglDepthRenderbuffer,O,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(be){t.bindTexture(n.TEXTURE_CUBE_MAP,de.__webglTexture),ft(n.TEXTURE_CUBE_MAP,E);for(let re=0;re<6;re++)if(E.mipmaps.length>0)for(let ae=0;ae<E.mipmaps.length;ae++)Ut(J.__webglFramebuffer[re][ae],O,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+re,ae);else Ut(J.__webglFramebuffer[re],O,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+re,0);S(E)?b(n.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}else if(Se){for(let re=0,ae=ce.length;re<ae;re++){let _e=ce[re],z=i.get(_e),le=n.TEXTURE_2D;(O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(le=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(le,z.__webglTexture),ft(le,_e),Ut(J.__webglFramebuffer,O,_e,n.COLOR_ATTACHMENT0+re,le,0),S(_e)&&b(le)}t.unbindTexture()}else{let re=n.TEXTURE_2D;if((O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(re=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,de.__webglTexture),ft(re,E),E.mipmaps.length>0)for(let ae=0;ae<E.mipmaps.length;ae++)Ut(J.__webglFramebuffer[ae],O,E,n.COLOR_ATTACHMENT0,re,ae);else Ut(J.__webglFramebuffer,O,E,n.COLOR_ATTACHMENT0,re,0);S(E)?b(re):E.mipmaps.length>0&&n.texParameteri(re,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}O.depthBuffer&&wn(O)}function V(O){let E=O.textures;for(let J=0,de=E.length;J<de;J++){let ce=E[J];if(S(ce)&&ce.mipmapsAutoUpdate===!0){let be=M(O),Se=i.get(ce).__webglTexture;t.bindTexture(be,Se),b(be),t.unbindTexture()}}}let Ie=[];function Je(O){if(O.samples>0){if(Te(O)===!1){let E=O.textures,J=O.width,de=O.height,ce=n.COLOR_BUFFER_BIT,be=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Se=i.get(O),re=E.length>1;if(re)for(let _e=0;_e<E.length;_e++)t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_e,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+_e,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Se.__webglMultisampledFramebuffer),O.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer);for(let _e=0;_e<E.length;_e++){if(O.resolveDepthBuffer&&(O.depthBuffer&&(ce|=n.DEPTH_BUFFER_BIT),O.stencilBuffer&&O.resolveStencilBuffer&&(ce|=n.STENCIL_BUFFER_BIT)),re){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Se.__webglColorRenderbuffer[_e]);let z=i.get(E[_e]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,z,0)}n.blitFramebuffer(0,0,J,de,0,0,J,de,ce,n.NEAREST),l===!0&&(Ie.length=0,Ie.push(n.COLOR_ATTACHMENT0+_e),O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&Ie.push(be),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ie))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),re)for(let _e=0;_e<E.length;_e++){t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_e,n.RENDERBUFFER,Se.__webglColorRenderbuffer[_e]);let z=i.get(E[_e]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+_e,n.TEXTURE_2D,z,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglMultisampledFramebuffer)}else if(O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&l){let E=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[E])}}}function at(O){return Math.min(s.maxSamples,O.samples)}function Te(O){let E=i.get(O);return O.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function zt(O){let E=o.render.frame;u.get(O)!==E&&(u.set(O,E),O.update())}function Ge(O,E){let J=O.colorSpace,de=O.format,ce=O.type;return O.isCompressedTexture===!0||O.isVideoTexture===!0||J!==al&&J!==Zs&&(yt.getTransfer(J)===Pt?(de!==is||ce!==pi)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):et("WebGLTextures: Unsupported texture color space:",J)),E}function $e(O){return typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement?(c.width=O.naturalWidth||O.width,c.height=O.naturalHeight||O.height):typeof VideoFrame<"u"&&O instanceof VideoFrame?(c.width=O.displayWidth,c.height=O.displayHeight):(c.width=O.width,c.height=O.height),c}this.allocateTextureUnit=ne,this.resetTextureUnits=Z,this.getTextureUnits=q,this.setTextureUnits=ie,this.setTexture2D=he,this.setTexture2DArray=me,this.setTexture3D=xe,this.setTextureCube=ve,this.rebindTextures=sn,this.setupRenderTarget=pn,this.updateRenderTargetMipmap=V,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=wn,this.setupFrameBufferTexture=Ut,this.useMultisampledRTT=Te,this.dispose=G}function VE(n,e){function t(i,s=Zs){let r,o=yt.getTransfer(s);if(i===pi)return n.UNSIGNED_BYTE;if(i===Gu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Hu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===ip)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===sp)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===tp)return n.BYTE;if(i===np)return n.SHORT;if(i===ga)return n.UNSIGNED_SHORT;if(i===Vu)return n.INT;if(i===ts)return n.UNSIGNED_INT;if(i===Vi)return n.FLOAT;if(i===ns)return n.HALF_FLOAT;if(i===rp)return n.ALPHA;if(i===op)return n.RGB;if(i===is)return n.RGBA;if(i===Gs)return n.DEPTH_COMPONENT;if(i===js)return n.DEPTH_STENCIL;if(i===Wu)return n.RED;if(i===Xu)return n.RED_INTEGER;if(i===Ar)return n.RG;if(i===qu)return n.RG_INTEGER;if(i===$u)return n.RGBA_INTEGER;if(i===Ll||i===Dl||i===Nl||i===Ol)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ll)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Dl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Nl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ol)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ll)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Dl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Nl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ol)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Yu||i===Ju||i===ju||i===Zu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Yu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Ju)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ju)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Zu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Ku||i===Qu||i===eh||i===th||i===nh||i===Fl||i===ih)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Ku||i===Qu)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===eh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===th)return r.COMPRESSED_R11_EAC;if(i===nh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Fl)return r.COMPRESSED_RG11_EAC;if(i===ih)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===sh||i===rh||i===oh||i===ah||i===lh||i===ch||i===uh||i===hh||i===fh||i===dh||i===ph||i===mh||i===gh||i===_h)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===sh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===rh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===oh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===ah)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===lh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===ch)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===uh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===hh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===fh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===dh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===ph)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===mh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===gh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===_h)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===xh||i===vh||i===yh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===xh)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===vh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===yh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===bh||i===Sh||i===Ul||i===Mh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===bh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Sh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ul)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Mh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===so?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var GE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,HE=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Ep=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new yl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new zi({vertexShader:GE,fragmentShader:HE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Mn(new bl(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Cp=class extends Qi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,x=null,y=typeof XRWebGLBinding<"u",p=new Ep,m={},_=t.getContextAttributes(),S=null,b=null,M=[],w=[],g=new Ze,T=null,L=null,P=new Ei;P.viewport=new kt;let D=new Ei;D.viewport=new kt;let I=[P,D],U=new Fu,N=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let he=M[K];return he===void 0&&(he=new la,M[K]=he),he.getTargetRaySpace()},this.getControllerGrip=function(K){let he=M[K];return he===void 0&&(he=new la,M[K]=he),he.getGripSpace()},this.getHand=function(K){let he=M[K];return he===void 0&&(he=new la,M[K]=he),he.getHandSpace()};function Y(K){let he=w.indexOf(K.inputSource);if(he===-1)return;let me=M[he];me!==void 0&&(me.update(K.inputSource,K.frame,c||o),me.dispatchEvent({type:K.type,data:K.inputSource}))}function k(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",k),s.removeEventListener("inputsourceschange",se);for(let K=0;K<M.length;K++){let he=w[K];he!==null&&(w[K]=null,M[K].disconnect(he))}N=null,G=null,p.reset();for(let K in m)delete m[K];if(e.setRenderTarget(S),d=null,f=null,h=null,s=null,b=null,ne.stop(),i.isPresenting=!1,e.setPixelRatio(T),e.setSize(g.width,g.height,!1),L!==null){let K=L.camera;K.fov=L.fov,K.zoom=L.zoom,K.updateProjectionMatrix(),L=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){r=K,i.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){a=K,i.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(K){c=K},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return x},this.getSession=function(){return s},this.setSession=async function(K){if(s=K,s!==null){if(S=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",k),s.addEventListener("inputsourceschange",se),_.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(g),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let me=null,xe=null,ve=null;_.depth&&(ve=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,me=_.stencil?js:Gs,xe=_.stencil?so:ts);let He={colorFormat:t.RGBA8,depthFormat:ve,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(He),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),b=new Ci(f.textureWidth,f.textureHeight,{format:is,type:pi,depthTexture:new Ys(f.textureWidth,f.textureHeight,xe,void 0,void 0,void 0,void 0,void 0,void 0,me),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let me={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,me),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),b=new Ci(d.framebufferWidth,d.framebufferHeight,{format:is,type:pi,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ne.setContext(s),ne.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function se(K){for(let he=0;he<K.removed.length;he++){let me=K.removed[he],xe=w.indexOf(me);xe>=0&&(w[xe]=null,M[xe].disconnect(me))}for(let he=0;he<K.added.length;he++){let me=K.added[he],xe=w.indexOf(me);if(xe===-1){for(let He=0;He<M.length;He++)if(He>=w.length){w.push(me),xe=He;break}else if(w[He]===null){w[He]=me,xe=He;break}if(xe===-1)break}let ve=M[xe];ve&&ve.connect(me)}}function $(K,he){he===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(he.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(s===null)return;let he=K.near,me=K.far;p.texture!==null&&(p.depthNear>0&&(he=p.depthNear),p.depthFar>0&&(me=p.depthFar)),U.near=D.near=P.near=he,U.far=D.far=P.far=me,(N!==U.near||G!==U.far)&&(s.updateRenderState({depthNear:U.near,depthFar:U.far}),N=U.near,G=U.far),U.layers.mask=K.layers.mask|6,P.layers.mask=U.layers.mask&-5,D.layers.mask=U.layers.mask&-3;let xe=K.parent,ve=U.cameras;$(U,xe);for(let He=0;He<ve.length;He++)$(ve[He],xe);U.projectionMatrix.copy(P.projectionMatrix),U.projectionMatrixInverse.copy(P.projectionMatrixInverse),L===null&&K.isPerspectiveCamera&&(L={camera:K,fov:K.fov,zoom:K.zoom}),Z(K,U,xe)};function Z(K,he,me){me===null?K.matrix.copy(he.matrixWorld):(K.matrix.copy(me.matrixWorld),K.matrix.invert(),K.matrix.multiply(he.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(he.projectionMatrix),K.projectionMatrixInverse.copy(he.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=ra*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return U},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(K){l=K,f!==null&&(f.fixedFoveation=K),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=K)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(U)},this.getCameraTexture=function(K){return m[K]};let q=null;function ie(K,he){if(u=he.getViewerPose(c||o),x=he,u!==null){let me=u.views;d!==null&&(e.setRenderTargetFramebuffer(b,d.framebuffer),e.setRenderTarget(b));let xe=!1;me.length!==U.cameras.length&&(U.cameras.length=0,xe=!0);for(let We=0;We<me.length;We++){let ft=me[We],ct=null;if(d!==null)ct=d.getViewport(ft);else{let Qt=h.getViewSubImage(f,ft);ct=Qt.viewport,We===0&&(e.setRenderTargetTextures(b,Qt.colorTexture,Qt.depthStencilTexture),e.setRenderTarget(b))}let st=I[We];st===void 0&&(st=new Ei,st.layers.enable(We),st.viewport=new kt,I[We]=st),st.matrix.fromArray(ft.transform.matrix),st.matrix.decompose(st.position,st.quaternion,st.scale),st.projectionMatrix.fromArray(ft.projectionMatrix),st.projectionMatrixInverse.copy(st.projectionMatrix).invert(),st.viewport.set(ct.x,ct.y,ct.width,ct.height),We===0&&(U.matrix.copy(st.matrix),U.matrix.decompose(U.position,U.quaternion,U.scale)),xe===!0&&U.cameras.push(st)}let ve=s.enabledFeatures;if(ve&&ve.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){h=i.getBinding();let We=h.getDepthInformation(me[0]);We&&We.isValid&&We.texture&&p.init(We,s.renderState)}if(ve&&ve.includes("camera-access")&&y){e.state.unbindTexture(),h=i.getBinding();for(let We=0;We<me.length;We++){let ft=me[We].camera;if(ft){let ct=m[ft];ct||(ct=new yl,m[ft]=ct);let st=h.getCameraImage(ft);ct.sourceTexture=st}}}}for(let me=0;me<M.length;me++){let xe=w[me],ve=M[me];xe!==null&&ve!==void 0&&ve.update(xe,he,c||o)}q&&q(K,he),he.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:he}),x=null}let ne=new Jx;ne.setAnimationLoop(ie),this.setAnimationLoop=function(K){q=K},this.dispose=function(){}}},WE=new mt,rv=new tt;rv.set(-1,0,0,0,1,0,0,0,1);function XE(n,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,mp(n)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,_,S,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),h(p,m)):m.isMeshPhongMaterial?(r(p,m),u(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),f(p,m),m.isMeshPhysicalMaterial&&d(p,m,b)):m.isMeshMatcapMaterial?(r(p,m),x(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),y(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,_,S):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===ui&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===ui&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let _=e.get(m),S=_.envMap,b=_.envMapRotation;S&&(p.envMap.value=S,p.envMapRotation.value.setFromMatrix4(WE.makeRotationFromEuler(b)).transpose(),S.isCubeTexture&&S.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(rv),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,_,S){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*_,p.scale.value=S*.5,m.map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function u(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function h(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function f(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function d(p,m,_){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ui&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=_.texture,p.transmissionSamplerSize.value.set(_.width,_.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,p.specularIntensityMapTransform))}function x(p,m){m.matcap&&(p.matcap.value=m.matcap)}function y(p,m){let _=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(_.matrixWorld),p.nearDistance.value=_.shadow.camera.near,p.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function qE(n,e,t,i){let s={},r={};function o(_,S){let b=S.program;i.uniformBlockBinding(_,b,s[_.id])}function a(_,S){let b=s[_.id];b===void 0&&(x(_),b=l(_),s[_.id]=b,_.addEventListener("dispose",p));let M=S.program;i.updateUBOMapping(_,M);let w=e.render.frame;r[_.id]!==w&&(c(_),r[_.id]=w)}function l(_){let S=n.createBuffer(),b=_.__size,M=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,S),n.bufferData(n.UNIFORM_BUFFER,b,M),n.bindBuffer(n.UNIFORM_BUFFER,null),S}function c(_){let S=s[_.id],b=_.uniforms,M=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,S);for(let w=0,g=b.length;w<g;w++){let T=b[w];if(Array.isArray(T))for(let L=0,P=T.length;L<P;L++)u(T[L],w,L,M);else u(T,w,0,M)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(_,S,b,M){if(f(_,S,b,M)===!0){let w=_.__offset,g=_.value;if(Array.isArray(g)){let T=0;for(let L=0;L<g.length;L++){let P=g[L],D=y(P,!0);h(P,_.__data,T),T+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else h(g,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,w,_.__data)}}function h(_,S,b){typeof _=="number"||typeof _=="boolean"?S[b]=_:_.isMatrix3?(S[b]=_.elements[0],S[b+1]=_.elements[1],S[b+2]=_.elements[2],S[b+3]=0,S[b+4]=_.elements[3],S[b+5]=_.elements[4],S[b+6]=_.elements[5],S[b+7]=0,S[b+8]=_.elements[6],S[b+9]=_.elements[7],S[b+10]=_.elements[8],S[b+11]=0):ArrayBuffer.isView(_)?S.set(_.subarray(0,S.length-b),b):_.toArray(S,b)}function f(_,S,b,M){let w=_.value,g=S+"_"+b;if(Array.isArray(w)){M[g]===void 0&&(M[g]=[]);let T=M[g],L=!1;for(let P=0;P<w.length;P++)d(w[P],T,P)===!0&&(L=!0);return L}return d(w,M,g)}function d(_,S,b){if(S[b]===void 0)return typeof _=="number"||typeof _=="boolean"?S[b]=_:ArrayBuffer.isView(_)?S[b]=_.slice():S[b]=_.clone(),!0;{let M=S[b];if(typeof _=="number"||typeof _=="boolean"){if(M!==_)return S[b]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(M.equals(_)===!1)return M.copy(_),!0}}return!1}function x(_){let S=_.uniforms,b=0,M=16;for(let g=0,T=S.length;g<T;g++){let L=Array.isArray(S[g])?S[g]:[S[g]];for(let P=0,D=L.length;P<D;P++){let I=L[P],U=Array.isArray(I.value)?I.value:[I.value],N=Array.isArray(S[g])||Array.isArray(I.value),G=b;for(let k=0,se=U.length;k<se;k++){let $=U[k],Z=y($,N),q=b%M,ie=q%Z.boundary,ne=q+ie;b+=ie,ne!==0&&M-ne<Z.storage&&(b+=M-ne),k===0&&(G=b),b+=Z.storage}let Y=I.type==="int"?Int32Array:I.type==="uint"?Uint32Array:Float32Array;I.__data=new Y((b-G)/Float32Array.BYTES_PER_ELEMENT),I.__offset=G}}let w=b%M;return w>0&&(b+=M-w),_.__size=b,_.__cache={},this}function y(_,S){let b={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(b.boundary=4,b.storage=4):_.isVector2?(b.boundary=8,b.storage=8):_.isVector3||_.isColor?(b.boundary=16,b.storage=12):_.isVector4?(b.boundary=16,b.storage=16):_.isMatrix3?(b.boundary=16,b.storage=48):_.isMatrix4?(b.boundary=16,b.storage=64):_.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(b.boundary=16,b.storage=_.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",_),S===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function p(_){let S=_.target;S.removeEventListener("dispose",p),n.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function m(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:m}}var $E=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ys=null;function YE(){return ys===null&&(ys=new $s($E,16,16,Ar,ns),ys.name="DFG_LUT",ys.minFilter=ci,ys.magFilter=ci,ys.wrapS=gs,ys.wrapT=gs,ys.generateMipmaps=!1,ys.needsUpdate=!0),ys}var Ss=class{constructor(e={}){let{canvas:t=xx(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=pi}=e;this.isWebGLRenderer=!0;let x;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");x=i.getContextAttributes().alpha}else x=o;let y=d,p=new Set([$u,qu,Xu]),m=new Set([pi,ts,ga,so,Gu,Hu]),_=new Uint32Array(4),S=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},M=null,w=null,g=[],T=[],L=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=vs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,D=!1,I=null,U=null,N=null,G=null;this._outputColorSpace=Yn;let Y=0,k=0,se=null,$=-1,Z=null,q=new kt,ie=new kt,ne=null,K=new it(0),he=0,me=t.width,xe=t.height,ve=1,He=null,ot=null,We=new kt(0,0,me,xe),ft=new kt(0,0,me,xe),ct=!1,st=new vr,Qt=new vu,Wt=!1,dn=!1,Ut=new mt,In=new W,St=new kt,wn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},sn=!1;function pn(){return se===null?ve:1}let V=i;function Ie(R,H){return t.getContext(R,H)}let Je,at,Te,zt,Ge,$e,O,E,J,de,ce,be,Se,re,ae,_e,z,le,oe,Ae,ye,we,Xe;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",Qe,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),V===null){let H="webgl2";if(V=Ie(H,R),V===null)throw Ie(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ke()}catch(R){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),et("WebGLRenderer: "+R.message),R}function Ke(){Je=new rA(V),Je.init(),ye=new VE(V,Je),at=new YT(V,Je,e,ye),Te=new kE(V,Je),at.reversedDepthBuffer&&f&&Te.buffers.depth.setReversed(!0),U=V.createFramebuffer(),N=V.createFramebuffer(),G=V.createFramebuffer(),zt=new lA(V),Ge=new TE,$e=new zE(V,Je,Te,Ge,at,ye,zt),O=new sA(P),E=new uw(V),we=new qT(V,E),J=new oA(V,E,zt,we),de=new uA(V,J,E,we,zt),le=new cA(V,at,$e),ae=new JT(Ge),ce=new wE(P,O,Je,at,we,ae),be=new XE(P,Ge),Se=new EE,re=new DE(Je),z=new XT(P,O,Te,de,x,l),_e=new BE(P,de,at),Xe=new qE(V,zt,at,Te),oe=new $T(V,Je,zt),Ae=new aA(V,Je,zt),zt.programs=ce.programs,P.capabilities=at,P.extensions=Je,P.properties=Ge,P.renderLists=Se,P.shadowMap=_e,P.state=Te,P.info=zt}y!==pi&&(L=new fA(y,t.width,t.height,a,s,r));let fe=new Cp(P,V);this.xr=fe,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let R=Je.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Je.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return ve},this.setPixelRatio=function(R){R!==void 0&&(ve=R,this.setSize(me,xe,!1))},this.getSize=function(R){return R.set(me,xe)},this.setSize=function(R,H,te=!0){if(fe.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}me=R,xe=H,t.width=Math.floor(R*ve),t.height=Math.floor(H*ve),te===!0&&(t.style.width=R+"px",t.style.height=H+"px"),L!==null&&L.setSize(t.width,t.height),this.setViewport(0,0,R,H)},this.getDrawingBufferSize=function(R){return R.set(me*ve,xe*ve).floor()},this.setDrawingBufferSize=function(R,H,te){me=R,xe=H,ve=te,t.width=Math.floor(R*te),t.height=Math.floor(H*te),this.setViewport(0,0,R,H)},this.setEffects=function(R){if(y===pi){et("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let H=0;H<R.length;H++)if(R[H].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}L.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(q)},this.getViewport=function(R){return R.copy(We)},this.setViewport=function(R,H,te,j){R.isVector4?We.set(R.x,R.y,R.z,R.w):We.set(R,H,te,j),Te.viewport(q.copy(We).multiplyScalar(pn()).round())},this.getScissor=function(R){return R.copy(ft)},this.setScissor=function(R,H,te,j){R.isVector4?ft.set(R.x,R.y,R.z,R.w):ft.set(R,H,te,j),Te.scissor(ie.copy(ft).multiplyScalar(pn()).round())},this.getScissorTest=function(){return ct},this.setScissorTest=function(R){Te.setScissorTest(ct=R)},this.setOpaqueSort=function(R){He=R},this.setTransparentSort=function(R){ot=R},this.getClearColor=function(R){return R.copy(z.getClearColor())},this.setClearColor=function(){z.setClearColor(...arguments)},this.getClearAlpha=function(){return z.getClearAlpha()},this.setClearAlpha=function(){z.setClearAlpha(...arguments)},this.clear=function(R=!0,H=!0,te=!0){let j=0;if(R){let Q=!1;if(se!==null){let Ee=se.texture.format;Q=p.has(Ee)}if(Q){let Ee=se.texture.type,Le=m.has(Ee),Ce=z.getClearColor(),De=z.getClearAlpha(),Ve=Ce.r,nt=Ce.g,dt=Ce.b;Le?(_[0]=Ve,_[1]=nt,_[2]=dt,_[3]=De,V.clearBufferuiv(V.COLOR,0,_)):(S[0]=Ve,S[1]=nt,S[2]=dt,S[3]=De,V.clearBufferiv(V.COLOR,0,S))}else j|=V.COLOR_BUFFER_BIT}H&&(j|=V.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),te&&(j|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),j!==0&&V.clear(j)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),I=R},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),z.dispose(),Se.dispose(),re.dispose(),$e.dispose(),Ge.dispose(),O.dispose(),de.dispose(),J.dispose(),we.dispose(),Xe.dispose(),ce.dispose(),fe.dispose(),fe.removeEventListener("sessionstart",$l),fe.removeEventListener("sessionend",os),As.stop()};function ke(R){R.preventDefault(),hp("WebGLRenderer: Context Lost."),D=!0}function Qe(){hp("WebGLRenderer: Context Restored."),D=!1;let R=zt.autoReset,H=_e.enabled,te=_e.autoUpdate,j=_e.needsUpdate,Q=_e.type;Ke(),zt.autoReset=R,_e.enabled=H,_e.autoUpdate=te,_e.needsUpdate=j,_e.type=Q}function Pe(R){et("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function lt(R){let H=R.target;H.removeEventListener("dispose",lt),Xt(H)}function Xt(R){Kn(R),Ge.remove(R)}function Kn(R){let H=Ge.get(R).programs;H!==void 0&&(H.forEach(function(te){ce.releaseProgram(te)}),R.isShaderMaterial&&ce.releaseShaderCache(R))}this.renderBufferDirect=function(R,H,te,j,Q,Ee){H===null&&(H=wn);let Le=Q.isMesh&&Q.matrixWorld.determinantAffine()<0,Ce=Ra(R,H,te,j,Q);Te.setMaterial(j,Le);let De=te.index,Ve=1;if(j.wireframe===!0){if(De=J.getWireframeAttribute(te),De===void 0)return;Ve=2}let nt=te.drawRange,dt=te.attributes.position,ze=nt.start*Ve,pt=(nt.start+nt.count)*Ve;Ee!==null&&(ze=Math.max(ze,Ee.start*Ve),pt=Math.min(pt,(Ee.start+Ee.count)*Ve)),De!==null?(ze=Math.max(ze,0),pt=Math.min(pt,De.count)):dt!=null&&(ze=Math.max(ze,0),pt=Math.min(pt,dt.count));let nn=pt-ze;if(nn<0||nn===1/0)return;we.setup(Q,j,Ce,te,De);let It,Lt=oe;if(De!==null&&(It=E.get(De),Lt=Ae,Lt.setIndex(It)),Q.isMesh)j.wireframe===!0?(Te.setLineWidth(j.wireframeLinewidth*pn()),Lt.setMode(V.LINES)):Lt.setMode(V.TRIANGLES);else if(Q.isLine){let Tn=j.linewidth;Tn===void 0&&(Tn=1),Te.setLineWidth(Tn*pn()),Q.isLineSegments?Lt.setMode(V.LINES):Q.isLineLoop?Lt.setMode(V.LINE_LOOP):Lt.setMode(V.LINE_STRIP)}else Q.isPoints?Lt.setMode(V.POINTS):Q.isSprite&&Lt.setMode(V.TRIANGLES);if(Q.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Lt.renderMultiDraw(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount);else{let Tn=Q._multiDrawStarts,Ue=Q._multiDrawCounts,mn=Q._multiDrawCount,_t=De?E.get(De).bytesPerElement:1,Cs=Ge.get(j).currentProgram.getUniforms();for(let gn=0;gn<mn;gn++)Cs.setValue(V,"_gl_DrawID",gn),Lt.render(Tn[gn]/_t,Ue[gn])}else if(Q.isInstancedMesh)Lt.renderInstances(ze,nn,Q.count);else if(te.isInstancedBufferGeometry){let Tn=te._maxInstanceCount!==void 0?te._maxInstanceCount:1/0,Ue=Math.min(te.instanceCount,Tn);Lt.renderInstances(ze,nn,Ue)}else Lt.render(ze,nn)};function Aa(R,H,te,j){I!==null&&R.isNodeMaterial&&I.setObject(j,R),Wt===!0&&ae.setState(R,te,!1),R.transparent===!0&&R.side===di&&R.forceSinglePass===!1?(R.side=ui,R.needsUpdate=!0,as(R,H,j),R.side=Tr,R.needsUpdate=!0,as(R,H,j),R.side=di):as(R,H,j)}this.compile=function(R,H,te=null){te===null&&(te=R),I!==null&&I.renderStart(R,H,te),w=re.get(te),w.init(H),T.push(w),te.traverseVisible(function(Q){Q.isLight&&Q.layers.test(H.layers)&&(w.pushLight(Q),Q.castShadow&&w.pushShadow(Q))}),R!==te&&R.traverseVisible(function(Q){Q.isLight&&Q.layers.test(H.layers)&&(w.pushLight(Q),Q.castShadow&&w.pushShadow(Q))}),w.setupLights(),I!==null&&I.updateLights(w.state.lightsArray),dn=this.localClippingEnabled,Wt=ae.init(this.clippingPlanes,dn),Wt===!0&&ae.setGlobalState(this.clippingPlanes,H),I!==null&&_e.render(w.state.shadowsArray,te,H);let j=new Set;return R.traverse(function(Q){if(!(Q.isMesh||Q.isPoints||Q.isLine||Q.isSprite))return;let Ee=Q.material;if(Ee)if(Array.isArray(Ee))for(let Le=0;Le<Ee.length;Le++){let Ce=Ee[Le];Aa(Ce,te,H,Q),j.add(Ce)}else Aa(Ee,te,H,Q),j.add(Ee)}),w=T.pop(),I!==null&&I.renderEnd(),j},this.compileAsync=function(R,H,te=null){let j=this.compile(R,H,te);return new Promise(Q=>{function Ee(){if(j.forEach(function(Le){let De=Ge.get(Le).currentProgram;(De===void 0||De.isReady())&&j.delete(Le)}),j.size===0){Q(R);return}setTimeout(Ee,10)}Je.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let po=null;function nf(R){po&&po(R)}function $l(){As.stop()}function os(){As.start()}let As=new Jx;As.setAnimationLoop(nf),typeof self<"u"&&As.setContext(self),this.setAnimationLoop=function(R){po=R,fe.setAnimationLoop(R),R===null?As.stop():As.start()},fe.addEventListener("sessionstart",$l),fe.addEventListener("sessionend",os),this.render=function(R,H){if(H!==void 0&&H.isCamera!==!0){et("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;I!==null&&I.renderStart(R,H);let te=fe.enabled===!0&&fe.isPresenting===!0,j=L!==null&&(se===null||te)&&L.begin(P,se);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),fe.enabled===!0&&fe.isPresenting===!0&&(L===null||L.isCompositing()===!1)&&(fe.cameraAutoUpdate===!0&&fe.updateCamera(H),H=fe.getCamera()),R.isScene===!0&&R.onBeforeRender(P,R,H,se),w=re.get(R,T.length),w.init(H),w.state.textureUnits=$e.getTextureUnits(),T.push(w),Ut.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?Qt.setFromArrayCamera(H):st.setFromProjectionMatrix(Ut,ki,H.reversedDepth),dn=this.localClippingEnabled,Wt=ae.init(this.clippingPlanes,dn),M=Se.get(R,g.length),M.init(),g.push(M),this.info.render.frame++,fe.enabled===!0&&fe.isPresenting===!0){let Le=P.xr.getDepthSensingMesh();Le!==null&&Es(Le,H,-1/0,P.sortObjects)}Es(R,H,0,P.sortObjects),M.finish(),I!==null&&I.updateLights(w.state.lightsArray),P.sortObjects===!0&&M.sort(He,ot),sn=fe.enabled===!1||fe.isPresenting===!1||fe.hasDepthSensing()===!1,sn&&z.addToRenderList(M,R),this.info.autoReset===!0&&this.info.reset(),Wt===!0&&ae.beginShadows();let Q=w.state.shadowsArray;if(_e.render(Q,R,H),Wt===!0&&ae.endShadows(),(j&&L.hasRenderPass())===!1){let Le=M.opaque,Ce=M.transmissive;if(w.setupLights(),H.isArrayCamera){let De=H.cameras;if(Ce.length>0)for(let Ve=0,nt=De.length;Ve<nt;Ve++){let dt=De[Ve];Gi(Le,Ce,R,dt)}sn&&z.render(R);for(let Ve=0,nt=De.length;Ve<nt;Ve++){let dt=De[Ve];Ea(M,R,dt,dt.viewport)}}else Ce.length>0&&Gi(Le,Ce,R,H),sn&&z.render(R),Ea(M,R,H)}se!==null&&k===0&&($e.updateMultisampleRenderTarget(se),$e.updateRenderTargetMipmap(se)),j&&L.end(P),R.isScene===!0&&R.onAfterRender(P,R,H),we.resetDefaultState(),$=-1,Z=null,T.pop(),T.length>0?(w=T[T.length-1],$e.setTextureUnits(w.state.textureUnits),Wt===!0&&ae.setGlobalState(P.clippingPlanes,w.state.camera)):w=null,g.pop(),g.length>0?M=g[g.length-1]:M=null,I!==null&&I.renderEnd()};function Es(R,H,te,j){if(R.visible===!1)return;if(R.layers.test(H.layers)){if(R.isGroup)te=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(H);else if(R.isLight)w.pushLight(R),R.castShadow&&w.pushShadow(R);else if(R.isSprite){let Le=H.isArrayCamera?Qt:st;if(!R.frustumCulled||R.intersectsFrustum(Le)){j&&St.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Ut);let Ce=de.update(R),De=R.material;De.visible&&M.push(R,Ce,De,te,St.z,null,H)}}else if(R.isMesh||R.isLine||R.isPoints){let Le=H.isArrayCamera?Qt:st;if(!R.frustumCulled||R.intersectsFrustum(Le)){let Ce=de.update(R),De=R.material;if(j&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),St.copy(R.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),St.copy(Ce.boundingSphere.center)),St.applyMatrix4(R.matrixWorld).applyMatrix4(Ut)),Array.isArray(De)){let Ve=Ce.groups;for(let nt=0,dt=Ve.length;nt<dt;nt++){let ze=Ve[nt],pt=De[ze.materialIndex];pt&&pt.visible&&M.push(R,Ce,pt,te,St.z,ze,H)}}else De.visible&&M.push(R,Ce,De,te,St.z,null,H)}}}let Ee=R.children;for(let Le=0,Ce=Ee.length;Le<Ce;Le++)Es(Ee[Le],H,te,j)}function Ea(R,H,te,j){let{opaque:Q,transmissive:Ee,transparent:Le}=R;w.setupLightsView(te),Wt===!0&&ae.setGlobalState(P.clippingPlanes,te),j&&Te.viewport(q.copy(j)),Q.length>0&&rn(Q,H,te),Ee.length>0&&rn(Ee,H,te),Le.length>0&&rn(Le,H,te),Te.buffers.depth.setTest(!0),Te.buffers.depth.setMask(!0),Te.buffers.color.setMask(!0),Te.setPolygonOffset(!1)}function Gi(R,H,te,j){if((te.isScene===!0?te.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[j.id]===void 0){let ze=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[j.id]=new Ci(1,1,{generateMipmaps:!0,type:ze?ns:pi,minFilter:Js,samples:Math.max(4,at.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:yt.workingColorSpace})}let Ee=w.state.transmissionRenderTarget[j.id],Le=j.viewport||q;Ee.setSize(Le.z*P.transmissionResolutionScale,Le.w*P.transmissionResolutionScale);let Ce=P.getRenderTarget(),De=P.getActiveCubeFace(),Ve=P.getActiveMipmapLevel();P.setRenderTarget(Ee),P.getClearColor(K),he=P.getClearAlpha(),he<1&&P.setClearColor(16777215,.5),P.clear(),sn&&z.render(te);let nt=P.toneMapping;P.toneMapping=vs;let dt=j.viewport;if(j.viewport!==void 0&&(j.viewport=void 0),w.setupLightsView(j),Wt===!0&&ae.setGlobalState(P.clippingPlanes,j),rn(R,te,j),$e.updateMultisampleRenderTarget(Ee),$e.updateRenderTargetMipmap(Ee),Je.has("WEBGL_multisampled_render_to_texture")===!1){let ze=!1;for(let pt=0,nn=H.length;pt<nn;pt++){let It=H[pt],{object:Lt,geometry:Tn,material:Ue,group:mn}=It;if(Ue.side===di&&Lt.layers.test(j.layers)){let _t=Ue.side;Ue.side=ui,Ue.needsUpdate=!0,un(Lt,te,j,Tn,Ue,mn),Ue.side=_t,Ue.needsUpdate=!0,ze=!0}}ze===!0&&($e.updateMultisampleRenderTarget(Ee),$e.updateRenderTargetMipmap(Ee))}P.setRenderTarget(Ce,De,Ve),P.setClearColor(K,he),dt!==void 0&&(j.viewport=dt),P.toneMapping=nt}function rn(R,H,te){let j=H.isScene===!0?H.overrideMaterial:null;for(let Q=0,Ee=R.length;Q<Ee;Q++){let Le=R[Q],{object:Ce,geometry:De,group:Ve}=Le,nt=Le.material;nt.allowOverride===!0&&j!==null&&(nt=j),Ce.layers.test(te.layers)&&un(Ce,H,te,De,nt,Ve)}}function un(R,H,te,j,Q,Ee){I!==null&&Q.isNodeMaterial&&I.setObject(R,Q),R.onBeforeRender(P,H,te,j,Q,Ee),R.modelViewMatrix.multiplyMatrices(te.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),Q.onBeforeRender(P,H,te,j,R,Ee),Q.transparent===!0&&Q.side===di&&Q.forceSinglePass===!1?(Q.side=ui,Q.needsUpdate=!0,P.renderBufferDirect(te,H,j,Q,R,Ee),Q.side=Tr,Q.needsUpdate=!0,P.renderBufferDirect(te,H,j,Q,R,Ee),Q.side=di):P.renderBufferDirect(te,H,j,Q,R,Ee),R.onAfterRender(P,H,te,j,Q,Ee)}function hn(R){let H=0;for(let te of R)te.texture!==null&&H++;return H}function as(R,H,te){H.isScene!==!0&&(H=wn);let j=Ge.get(R),Q=w.state.lights,Ee=w.state.shadowsArray,Le=Q.state.version,Ce=ce.getParameters(R,Q.state,Ee,H,te,w.state.lightProbeGridArray),De=ce.getProgramCacheKey(Ce),Ve=j.programs;j.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?H.environment:null,j.fog=H.fog;let nt=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;j.envMap=O.get(R.envMap||j.environment,nt),j.envMapRotation=j.environment!==null&&R.envMap===null?H.environmentRotation:R.envMapRotation,Ve===void 0&&(R.addEventListener("dispose",lt),Ve=new Map,j.programs=Ve,j.programVariants=new Map);let dt=Ve.get(De);if(dt!==void 0){if(j.currentProgram===dt&&j.lightsStateVersion===Le)return Ca(R,Ce),dt}else Ce.uniforms=ce.getUniforms(R),I!==null&&R.isNodeMaterial&&I.build(R,te,Ce),R.onBeforeCompile(Ce,P),dt=ce.acquireProgram(Ce,De),Ve.set(De,dt),j.uniforms=Ce.uniforms;let ze=j.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(ze.clippingPlanes=ae.uniform),Ca(R,Ce),j.needsLights=ir(R),j.lightsStateVersion=Le,j.needsLights&&(ze.ambientLightColor.value=Q.state.ambient,ze.lightProbe.value=Q.state.probe,ze.sunLights.value=Q.state.sun,ze.sunLightShadows.value=Q.state.sunShadow,ze.directionalLights.value=Q.state.directional,ze.directionalLightShadows.value=Q.state.directionalShadow,ze.spotLights.value=Q.state.spot,ze.spotLightShadows.value=Q.state.spotShadow,ze.rectAreaLights.value=Q.state.rectArea,ze.ltc_1.value=Q.state.rectAreaLTC1,ze.ltc_2.value=Q.state.rectAreaLTC2,ze.pointLights.value=Q.state.point,ze.pointLightShadows.value=Q.state.pointShadow,ze.hemisphereLights.value=Q.state.hemi,ze.sunShadowMatrix.value=Q.state.sunShadowMatrix,ze.sunShadowCascade.value=Q.state.sunShadowCascade,ze.directionalShadowMatrix.value=Q.state.directionalShadowMatrix,ze.spotLightMatrix.value=Q.state.spotLightMatrix,ze.spotLightMap.value=Q.state.spotLightMap,ze.pointShadowMatrix.value=Q.state.pointShadowMatrix),j.numLightProbeGrids=hn(w.state.lightProbeGridArray),j.currentProgram=dt,j.uniformsList=null,dt}function gi(R,H,te,j,Q){let Ee=Ge.get(R),Le=Ee.currentProgram.id+","+j+","+Q,Ce=Ee.programVariants.get(Le);return Ce===void 0?(Ce=as(R,H,te),Ee.programVariants.set(Le,Ce)):(Ee.currentProgram=Ce,Ee.uniformsList=null,Ee.outputColorSpace=j,Ee.toneMapping=Q),Ce}function nr(R){if(R.uniformsList===null){let H=R.currentProgram.getUniforms();R.uniformsList=xa.seqWithValue(H.seq,R.uniforms)}return R.uniformsList}function Ca(R,H){let te=Ge.get(R);te.outputColorSpace=H.outputColorSpace,te.batching=H.batching,te.batchingColor=H.batchingColor,te.instancing=H.instancing,te.instancingColor=H.instancingColor,te.instancingMorph=H.instancingMorph,te.skinning=H.skinning,te.morphTargets=H.morphTargets,te.morphNormals=H.morphNormals,te.morphColors=H.morphColors,te.morphTargetsCount=H.morphTargetsCount,te.numClippingPlanes=H.numClippingPlanes,te.numIntersection=H.numClipIntersection,te.vertexAlphas=H.vertexAlphas,te.vertexTangents=H.vertexTangents,te.toneMapping=H.toneMapping}function Ra(R,H,te,j,Q){H.isScene!==!0&&(H=wn),$e.resetTextureUnits();let Ee=H.fog,Le=j.isMeshStandardMaterial||j.isMeshLambertMaterial||j.isMeshPhongMaterial?H.environment:null,Ce=se===null?P.outputColorSpace:se.isXRRenderTarget===!0?se.texture.colorSpace:yt.workingColorSpace,De=j.isMeshStandardMaterial||j.isMeshLambertMaterial&&!j.envMap||j.isMeshPhongMaterial&&!j.envMap,Ve=O.get(j.envMap||Le,De),nt=j.vertexColors===!0&&!!te.attributes.color&&te.attributes.color.itemSize===4,dt=!!te.attributes.tangent&&(!!j.normalMap||j.anisotropy>0),ze=!!te.morphAttributes.position,pt=!!te.morphAttributes.normal,nn=!!te.morphAttributes.color,It=vs;j.toneMapped&&(se===null||se.isXRRenderTarget===!0)&&(It=P.toneMapping);let Lt=te.morphAttributes.position||te.morphAttributes.normal||te.morphAttributes.color,Tn=Lt!==void 0?Lt.length:0,Ue=Ge.get(j),mn=w.state.lights;if(Wt===!0&&(dn===!0||R!==Z)){let Dt=R===Z&&j.id===$;ae.setState(j,R,Dt)}let _t=!1,Cs=!1;j.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==mn.state.version||Q.isBatchedMesh&&Ue.batching===!1||!Q.isBatchedMesh&&Ue.batching===!0||Q.isBatchedMesh&&Ue.batchingColor===!0&&Q._colorsTexture===null||Q.isBatchedMesh&&Ue.batchingColor===!1&&Q._colorsTexture!==null||Q.isInstancedMesh&&Ue.instancing===!1||!Q.isInstancedMesh&&Ue.instancing===!0||Q.isSkinnedMesh&&Ue.skinning===!1||!Q.isSkinnedMesh&&Ue.skinning===!0||Q.isInstancedMesh&&Ue.instancingColor===!0&&Q.instanceColor===null||Q.isInstancedMesh&&Ue.instancingColor===!1&&Q.instanceColor!==null||Q.isInstancedMesh&&Ue.instancingMorph===!0&&Q.morphTexture===null||Q.isInstancedMesh&&Ue.instancingMorph===!1&&Q.morphTexture!==null||Ue.envMap!==Ve||j.fog===!0&&Ue.fog!==Ee||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==ae.numPlanes||Ue.numIntersection!==ae.numIntersection)||Ue.vertexAlphas!==nt||Ue.vertexTangents!==dt||Ue.morphTargets!==ze||Ue.morphNormals!==pt||Ue.morphColors!==nn||Ue.morphTargetsCount!==Tn||Ue.numLightProbeGrids!==hn(w.state.lightProbeGridArray)?_t=!0:(Ue.outputColorSpace!==Ce||Ue.toneMapping!==It)&&(Cs=!0):(_t=!0,Ue.__version=j.version);let gn=Ue.currentProgram;(_t===!0||Cs===!0)&&(gn=Cs===!0?gi(j,H,Q,Ce,It):as(j,H,Q),I&&j.isNodeMaterial&&I.onUpdateProgram(j,gn,Ue));let _o=!1,ls=!1,Rs=!1,ut=gn.getUniforms(),on=Ue.uniforms;if(Te.useProgram(gn.program)&&(_o=!0,ls=!0,Rs=!0),j.id!==$&&($=j.id,ls=!0),_o||Z!==R){Te.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),ut.setValue(V,"projectionMatrix",R.projectionMatrix),ut.setValue(V,"viewMatrix",R.matrixWorldInverse);let _n=ut.map.cameraPosition;_n!==void 0&&_n.setValue(V,In.setFromMatrixPosition(R.matrixWorld)),at.logarithmicDepthBuffer&&ut.setValue(V,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(j.isMeshPhongMaterial||j.isMeshToonMaterial||j.isMeshLambertMaterial||j.isMeshBasicMaterial||j.isMeshStandardMaterial||j.isShaderMaterial)&&ut.setValue(V,"isOrthographic",R.isOrthographicCamera===!0),Z!==R&&(Z=R,ls=!0,Rs=!0)}if(Ue.needsLights&&(mn.state.sunShadowMap.length>0&&ut.setValue(V,"sunShadowMap",mn.state.sunShadowMap,$e),mn.state.directionalShadowMap.length>0&&ut.setValue(V,"directionalShadowMap",mn.state.directionalShadowMap,$e),mn.state.spotShadowMap.length>0&&ut.setValue(V,"spotShadowMap",mn.state.spotShadowMap,$e),mn.state.pointShadowMap.length>0&&ut.setValue(V,"pointShadowMap",mn.state.pointShadowMap,$e)),Q.isSkinnedMesh){ut.setOptional(V,Q,"bindMatrix"),ut.setOptional(V,Q,"bindMatrixInverse");let Dt=Q.skeleton;Dt&&(Dt.boneTexture===null&&Dt.computeBoneTexture(),ut.setValue(V,"boneTexture",Dt.boneTexture,$e))}Q.isBatchedMesh&&(ut.setOptional(V,Q,"batchingTexture"),ut.setValue(V,"batchingTexture",Q._matricesTexture,$e),ut.setOptional(V,Q,"batchingIdTexture"),ut.setValue(V,"batchingIdTexture",Q._indirectTexture,$e),ut.setOptional(V,Q,"batchingColorTexture"),Q._colorsTexture!==null&&ut.setValue(V,"batchingColorTexture",Q._colorsTexture,$e));let Qn=te.morphAttributes;if((Qn.position!==void 0||Qn.normal!==void 0||Qn.color!==void 0)&&le.update(Q,te,gn),(ls||Ue.receiveShadow!==Q.receiveShadow)&&(Ue.receiveShadow=Q.receiveShadow,ut.setValue(V,"receiveShadow",Q.receiveShadow)),(j.isMeshStandardMaterial||j.isMeshLambertMaterial||j.isMeshPhongMaterial)&&j.envMap===null&&H.environment!==null&&(on.envMapIntensity.value=H.environmentIntensity),on.dfgLUT!==void 0&&(on.dfgLUT.value=YE()),ls){if(ut.setValue(V,"toneMappingExposure",P.toneMappingExposure),Ue.needsLights&&mo(on,Rs),Ee&&j.fog===!0&&be.refreshFogUniforms(on,Ee),be.refreshMaterialUniforms(on,j,ve,xe,w.state.transmissionRenderTarget[R.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Dt=b,_n=0;for(let Gn of w.state.lightProbeGridArray)Gn.texture!==null&&(Dt.textures[_n]=Gn.texture,Dt.min[_n]=Gn.boundingBox.min,Dt.max[_n]=Gn.boundingBox.max,Dt.resolution[_n]=Gn.resolution,_n++);for(let Gn in Dt)Dt[Gn].length=_n;on.probesSH.value=Dt.textures,on.probesMin.value=Dt.min,on.probesMax.value=Dt.max,on.probesResolution.value=Dt.resolution}xa.upload(V,nr(Ue),on,$e)}if(j.isShaderMaterial&&j.uniformsNeedUpdate===!0&&(xa.upload(V,nr(Ue),on,$e),j.uniformsNeedUpdate=!1),j.isSpriteMaterial&&ut.setValue(V,"center",Q.center),ut.setValue(V,"modelViewMatrix",Q.modelViewMatrix),ut.setValue(V,"normalMatrix",Q.normalMatrix),ut.setValue(V,"modelMatrix",Q.matrixWorld),j.uniformsGroups!==void 0){let Dt=j.uniformsGroups;for(let _n=0,Gn=Dt.length;_n<Gn;_n++){let Yl=Dt[_n];Xe.update(Yl,gn),Xe.bind(Yl,gn)}}return gn}function mo(R,H){R.ambientLightColor.needsUpdate=H,R.lightProbe.needsUpdate=H,R.sunLights.needsUpdate=H,R.sunLightShadows.needsUpdate=H,R.directionalLights.needsUpdate=H,R.directionalLightShadows.needsUpdate=H,R.pointLights.needsUpdate=H,R.pointLightShadows.needsUpdate=H,R.spotLights.needsUpdate=H,R.spotLightShadows.needsUpdate=H,R.rectAreaLights.needsUpdate=H,R.hemisphereLights.needsUpdate=H}function ir(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return k},this.getRenderTarget=function(){return se},this.setRenderTargetTextures=function(R,H,te){let j=Ge.get(R);j.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,j.__autoAllocateDepthBuffer===!1&&(j.__useRenderToTexture=!1),Ge.get(R.texture).__webglTexture=H,Ge.get(R.depthTexture).__webglTexture=j.__autoAllocateDepthBuffer?void 0:te,j.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,H){let te=Ge.get(R);te.__webglFramebuffer=H,te.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(R,H=0,te=0){se=R,Y=H,k=te;let j=null,Q=!1,Ee=!1;if(R){let Ce=Ge.get(R);if(Ce.__useDefaultFramebuffer!==void 0){Te.bindFramebuffer(V.FRAMEBUFFER,Ce.__webglFramebuffer),q.copy(R.viewport),ie.copy(R.scissor),ne=R.scissorTest,Te.viewport(q),Te.scissor(ie),Te.setScissorTest(ne),$=-1;return}else if(Ce.__webglFramebuffer===void 0)$e.setupRenderTarget(R);else if(Ce.__hasExternalTextures)$e.rebindTextures(R,Ge.get(R.texture).__webglTexture,Ge.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let nt=R.depthTexture;if(Ce.__boundDepthTexture!==nt){if(nt!==null&&Ge.has(nt)&&(R.width!==nt.image.width||R.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(R)}}let De=R.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ee=!0);let Ve=Ge.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Ve[H])?j=Ve[H][te]:j=Ve[H],Q=!0):R.samples>0&&$e.useMultisampledRTT(R)===!1?j=Ge.get(R).__webglMultisampledFramebuffer:Array.isArray(Ve)?j=Ve[te]:j=Ve,q.copy(R.viewport),ie.copy(R.scissor),ne=R.scissorTest}else q.copy(We).multiplyScalar(ve).floor(),ie.copy(ft).multiplyScalar(ve).floor(),ne=ct;if(te!==0&&(j=U),Te.bindFramebuffer(V.FRAMEBUFFER,j)&&Te.drawBuffers(R,j),Te.viewport(q),Te.scissor(ie),Te.setScissorTest(ne),Q){let Ce=Ge.get(R.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+H,Ce.__webglTexture,te)}else if(Ee){let Ce=H;for(let De=0;De<R.textures.length;De++){let Ve=Ge.get(R.textures[De]);V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0+De,Ve.__webglTexture,te,Ce)}}else if(R!==null&&te!==0){let Ce=Ge.get(R.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,Ce.__webglTexture,te)}$=-1};function go(R){let H=Ge.get(R);return(H.__readFormat!==R.format||H.__readType!==R.type)&&(H.__readFormat=R.format,H.__readType=R.type,H.__formatReadable=at.textureFormatReadable(R.format),H.__typeReadable=at.textureTypeReadable(R.type)),H}this.readRenderTargetPixels=function(R,H,te,j,Q,Ee,Le,Ce=0){if(!(R&&R.isWebGLRenderTarget)){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=Ge.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De){Te.bindFramebuffer(V.FRAMEBUFFER,De);try{let Ve=R.textures[Ce],nt=Ve.format,dt=Ve.type;R.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Ce);let ze=go(Ve);if(ze.__formatReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ze.__typeReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=R.width-j&&te>=0&&te<=R.height-Q&&V.readPixels(H,te,j,Q,ye.convert(nt),ye.convert(dt),Ee)}finally{let Ve=se!==null?Ge.get(se).__webglFramebuffer:null;Te.bindFramebuffer(V.FRAMEBUFFER,Ve)}}},this.readRenderTargetPixelsAsync=async function(R,H,te,j,Q,Ee,Le,Ce=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=Ge.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De)if(H>=0&&H<=R.width-j&&te>=0&&te<=R.height-Q){Te.bindFramebuffer(V.FRAMEBUFFER,De);let Ve=R.textures[Ce],nt=Ve.format,dt=Ve.type;R.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Ce);let ze=go(Ve);if(ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pt=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,pt),V.bufferData(V.PIXEL_PACK_BUFFER,Ee.byteLength,V.STREAM_READ),V.readPixels(H,te,j,Q,ye.convert(nt),ye.convert(dt),0),V.bindBuffer(V.PIXEL_PACK_BUFFER,null);let nn=se!==null?Ge.get(se).__webglFramebuffer:null;Te.bindFramebuffer(V.FRAMEBUFFER,nn);let It=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await yx(V,It,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,pt),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,Ee),V.bindBuffer(V.PIXEL_PACK_BUFFER,null),V.deleteBuffer(pt),V.deleteSync(It),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,H=null,te=0){let j=Math.pow(2,-te),Q=Math.floor(R.image.width*j),Ee=Math.floor(R.image.height*j),Le=H!==null?H.x:0,Ce=H!==null?H.y:0;$e.setTexture2D(R,0),V.copyTexSubImage2D(V.TEXTURE_2D,te,0,0,Le,Ce,Q,Ee),Te.unbindTexture()},this.copyTextureToTexture=function(R,H,te=null,j=null,Q=0,Ee=0){let Le,Ce,De,Ve,nt,dt,ze,pt,nn,It=R.isCompressedTexture?R.mipmaps[Ee]:R.image;if(te!==null)Le=te.max.x-te.min.x,Ce=te.max.y-te.min.y,De=te.isBox3?te.max.z-te.min.z:1,Ve=te.min.x,nt=te.min.y,dt=te.isBox3?te.min.z:0;else{let ut=Math.pow(2,-Q);Le=Math.floor(It.width*ut),Ce=Math.floor(It.height*ut),R.isDataArrayTexture?De=It.depth:R.isData3DTexture?De=Math.floor(It.depth*ut):De=1,Ve=0,nt=0,dt=0}j!==null?(ze=j.x,pt=j.y,nn=j.z):(ze=0,pt=0,nn=0);let Lt=ye.convert(H.format),Tn=ye.convert(H.type),Ue;H.isData3DTexture?($e.setTexture3D(H,0),Ue=V.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?($e.setTexture2DArray(H,0),Ue=V.TEXTURE_2D_ARRAY):($e.setTexture2D(H,0),Ue=V.TEXTURE_2D),Te.activeTexture(V.TEXTURE0),Te.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,H.flipY),Te.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),Te.pixelStorei(V.UNPACK_ALIGNMENT,H.unpackAlignment);let mn=Te.getParameter(V.UNPACK_ROW_LENGTH),_t=Te.getParameter(V.UNPACK_IMAGE_HEIGHT),Cs=Te.getParameter(V.UNPACK_SKIP_PIXELS),gn=Te.getParameter(V.UNPACK_SKIP_ROWS),_o=Te.getParameter(V.UNPACK_SKIP_IMAGES);Te.pixelStorei(V.UNPACK_ROW_LENGTH,It.width),Te.pixelStorei(V.UNPACK_IMAGE_HEIGHT,It.height),Te.pixelStorei(V.UNPACK_SKIP_PIXELS,Ve),Te.pixelStorei(V.UNPACK_SKIP_ROWS,nt),Te.pixelStorei(V.UNPACK_SKIP_IMAGES,dt);let ls=R.isDataArrayTexture||R.isData3DTexture,Rs=H.isDataArrayTexture||H.isData3DTexture;if(R.isDepthTexture){let ut=Ge.get(R),on=Ge.get(H),Qn=Ge.get(ut.__renderTarget),Dt=Ge.get(on.__renderTarget);Te.bindFramebuffer(V.READ_FRAMEBUFFER,Qn.__webglFramebuffer),Te.bindFramebuffer(V.DRAW_FRAMEBUFFER,Dt.__webglFramebuffer);for(let _n=0;_n<De;_n++)ls&&(V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Ge.get(R).__webglTexture,Q,dt+_n),V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Ge.get(H).__webglTexture,Ee,nn+_n)),V.blitFramebuffer(Ve,nt,Ve+Le,nt+Ce,ze,pt,ze+Le,pt+Ce,V.DEPTH_BUFFER_BIT,V.NEAREST);Te.bindFramebuffer(V.READ_FRAMEBUFFER,null),Te.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else if(Q!==0||R.isRenderTargetTexture||Ge.has(R)){let ut=Ge.get(R),on=Ge.get(H);Te.bindFramebuffer(V.READ_FRAMEBUFFER,N),Te.bindFramebuffer(V.DRAW_FRAMEBUFFER,G);for(let Qn=0;Qn<De;Qn++)ls?V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,ut.__webglTexture,Q,dt+Qn):V.framebufferTexture2D(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,ut.__webglTexture,Q),Rs?V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,on.__webglTexture,Ee,nn+Qn):V.framebufferTexture2D(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,on.__webglTexture,Ee),Q!==0?V.blitFramebuffer(Ve,nt,Ve+Le,nt+Ce,ze,pt,ze+Le,pt+Ce,V.COLOR_BUFFER_BIT,V.NEAREST):Rs?V.copyTexSubImage3D(Ue,Ee,ze,pt,nn+Qn,Ve,nt,Le,Ce):V.copyTexSubImage2D(Ue,Ee,ze,pt,Ve,nt,Le,Ce);Te.bindFramebuffer(V.READ_FRAMEBUFFER,null),Te.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else Rs?R.isDataTexture||R.isData3DTexture?V.texSubImage3D(Ue,Ee,ze,pt,nn,Le,Ce,De,Lt,Tn,It.data):H.isCompressedArrayTexture?V.compressedTexSubImage3D(Ue,Ee,ze,pt,nn,Le,Ce,De,Lt,It.data):V.texSubImage3D(Ue,Ee,ze,pt,nn,Le,Ce,De,Lt,Tn,It):R.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,Ee,ze,pt,Le,Ce,Lt,Tn,It.data):R.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,Ee,ze,pt,It.width,It.height,Lt,It.data):V.texSubImage2D(V.TEXTURE_2D,Ee,ze,pt,Le,Ce,Lt,Tn,It);Te.pixelStorei(V.UNPACK_ROW_LENGTH,mn),Te.pixelStorei(V.UNPACK_IMAGE_HEIGHT,_t),Te.pixelStorei(V.UNPACK_SKIP_PIXELS,Cs),Te.pixelStorei(V.UNPACK_SKIP_ROWS,gn),Te.pixelStorei(V.UNPACK_SKIP_IMAGES,_o),Ee===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&V.generateMipmap(Ue),Te.unbindTexture()},this.initRenderTarget=function(R){Ge.get(R).__webglFramebuffer===void 0&&$e.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?$e.setTextureCube(R,0):R.isData3DTexture?$e.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?$e.setTexture2DArray(R,0):$e.setTexture2D(R,0),Te.unbindTexture()},this.resetState=function(){Y=0,k=0,se=null,Te.reset(),we.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ki}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=yt._getDrawingBufferColorSpace(e),t.unpackColorSpace=yt._getUnpackColorSpace()}};var ss=new it,Ih=class extends Qr{constructor(e){super(e),this.propertyNameMapping={},this.customPropertyMapping={}}load(e,t,i,s){let r=this,o=new wl(this.manager);o.setPriority(this.priority),o.setCache(this.cache),o.setPath(this.path),o.setResponseType("arraybuffer"),o.setRequestHeader(this.requestHeader),o.setWithCredentials(this.withCredentials),o.load(e,function(a){try{t(r.parse(a))}catch(l){s?s(l):console.error(l),r.manager.itemError(e)}},i,s)}setPropertyNameMapping(e){this.propertyNameMapping=e}setCustomPropertyNameMapping(e){this.customPropertyMapping=e}parse(e){function t(S,b=0){let M=/^ply([\s\S]*)end_header(\r\n|\r|\n)/,w="",g=M.exec(S);g!==null&&(w=g[1]);let T={comments:[],elements:[],headerLength:b,objInfo:""},L=w.split(/\r\n|\r|\n/),P;function D(I,U){let N={type:I[0]};return N.type==="list"?(N.name=I[3],N.countType=I[1],N.itemType=I[2]):N.name=I[1],N.name in U&&(N.name=U[N.name]),N}for(let I=0;I<L.length;I++){let U=L[I];if(U=U.trim(),U==="")continue;let N=U.split(/\s+/),G=N.shift();switch(U=N.join(" "),G){case"format":T.format=N[0],T.version=N[1];break;case"comment":T.comments.push(U);break;case"element":P!==void 0&&T.elements.push(P),P={},P.name=N[0],P.count=parseInt(N[1]),P.properties=[];break;case"property":P.properties.push(D(N,_.propertyNameMapping));break;case"obj_info":T.objInfo=U;break;default:console.log("unhandled",G,N)}}return P!==void 0&&T.elements.push(P),T}function i(S,b){switch(b){case"char":case"uchar":case"short":case"ushort":case"int":case"uint":case"int8":case"uint8":case"int16":case"uint16":case"int32":case"uint32":return parseInt(S);case"float":case"double":case"float32":case"float64":return parseFloat(S)}}function s(S,b){let M={};for(let w=0;w<S.length;w++){if(b.empty())return null;if(S[w].type==="list"){let g=[],T=i(b.next(),S[w].countType);for(let L=0;L<T;L++){if(b.empty())return null;g.push(i(b.next(),S[w].itemType))}M[S[w].name]=g}else M[S[w].name]=i(b.next(),S[w].type)}return M}function r(){let S={indices:[],vertices:[],normals:[],uvs:[],faceVertexUvs:[],colors:[],faceVertexColors:[],descriptors:{}};for(let b of Object.keys(_.customPropertyMapping))S[b]=[];return S}function o(S){switch(S){case"int8":case"char":return hl;case"uint8":case"uchar":return fl;case"int16":case"short":return dl;case"uint16":case"ushort":return Zr;case"int32":case"int":return pl;case"uint32":case"uint":return Kr;case"float32":case"float":return Cn;case"float64":case"double":return Rp}}function a(S){switch(S){case"uchar":case"uint8":return 1/255;case"ushort":case"uint16":return 1/65535;case"float":case"float32":case"double":case"float64":return 1;default:return 1/255}}function l(S){return S==="float"||S==="float32"||S==="double"||S==="float64"}function c(S){function b(se){for(let $ of se){let Z=S.find(q=>q.name===$);if(Z)return Z}return null}let M=b(["x","px","posx"]),w=b(["y","py","posy"]),g=b(["z","pz","posz"]),T=b(["nx","normalx"]),L=b(["ny","normaly"]),P=b(["nz","normalz"]),D=b(["s","u","texture_u","tx"]),I=b(["t","v","texture_v","ty"]),U=b(["red","diffuse_red","r","diffuse_r"]),N=b(["green","diffuse_green","g","diffuse_g"]),G=b(["blue","diffuse_blue","b","diffuse_b"]),Y=b(["texcoord"]),k={};for(let se of Object.keys(_.customPropertyMapping)){let Z=_.customPropertyMapping[se].map(ne=>S.find(K=>K.name===ne)),q=Z.filter(ne=>ne).map(ne=>ne.type),ie=q.length>0&&q.every(ne=>ne===q[0]);k[se]={type:ie?q[0]:"float32",usage:Z.every(ne=>ne!==void 0)}}return{position:{names:[M?M.name:"x",w?w.name:"y",g?g.name:"z"],type:M?M.type:"float32",usage:!!(M&&w&&g)},normal:{names:[T?T.name:"nx",L?L.name:"ny",P?P.name:"nz"],type:T?T.type:"float32",usage:!!(T&&L&&P)},uv:{names:[D?D.name:"s",I?I.name:"t"],type:D?D.type:"float32",usage:!!(D&&I)},texcoord:{type:Y?Y.itemType:"float32",usage:!!Y},color:{names:[U?U.name:"red",N?N.name:"green",G?G.name:"blue"],type:U?U.type:"uchar",usage:!!(U&&N&&G)},custom:k}}function u(S,b){let M=r(),w=/end_header\s+(\S[\s\S]*\S|\S)\s*$/,g,T;(T=w.exec(S))!==null?g=T[1].split(/\s+/):g=[];let L=new Pp(g);e:for(let P=0;P<b.elements.length;P++){let D=b.elements[P],I=c(D.properties);M.descriptors[D.name]=I;for(let U=0;U<D.count;U++){let N=s(D.properties,L);if(!N)break e;f(M,D.name,N,I)}}return h(M)}function h(S){let b=new Jn,M=S.descriptors.vertex;S.indices.length>0&&b.setIndex(S.indices);let w=o(M?M.position.type:"float32");if(b.setAttribute("position",new w(S.vertices,3)),S.normals.length>0){let g=o(M.normal.type);b.setAttribute("normal",new g(S.normals,3))}if(S.uvs.length>0){let g=o(M.uv.type);b.setAttribute("uv",new g(S.uvs,2))}if(S.colors.length>0){let g=M.color.type,T=!l(g),L=o(g);b.setAttribute("color",new L(S.colors,3,T))}for(let g of Object.keys(_.customPropertyMapping))if(S[g].length>0){let T=o(M.custom[g].type);b.setAttribute(g,new T(S[g],_.customPropertyMapping[g].length))}if(S.faceVertexUvs.length>0||S.faceVertexColors.length>0){if(b=b.toNonIndexed(),S.faceVertexUvs.length>0){let g=o(S.descriptors.face.texcoord.type);b.setAttribute("uv",new g(S.faceVertexUvs,2))}if(S.faceVertexColors.length>0){let g=S.descriptors.face.color.type,T=!l(g),L=o(g);b.setAttribute("color",new L(S.faceVertexColors,3,T))}}return b.computeBoundingSphere(),b}function f(S,b,M,w){if(b==="vertex"){let{position:g,normal:T,uv:L,color:P}=w;if(g.usage&&S.vertices.push(M[g.names[0]],M[g.names[1]],M[g.names[2]]),T.usage&&S.normals.push(M[T.names[0]],M[T.names[1]],M[T.names[2]]),L.usage&&S.uvs.push(M[L.names[0]],M[L.names[1]]),P.usage){let D=a(P.type),I=l(P.type);ss.setRGB(M[P.names[0]]*D,M[P.names[1]]*D,M[P.names[2]]*D,Yn);let U=1/D;S.colors.push(I?ss.r:Math.round(ss.r*U),I?ss.g:Math.round(ss.g*U),I?ss.b:Math.round(ss.b*U))}for(let D of Object.keys(_.customPropertyMapping))for(let I of _.customPropertyMapping[D])S[D].push(M[I])}else if(b==="face"){let g=M.vertex_indices||M.vertex_index,T=M.texcoord;g.length===3?(S.indices.push(g[0],g[1],g[2]),T&&T.length===6&&(S.faceVertexUvs.push(T[0],T[1]),S.faceVertexUvs.push(T[2],T[3]),S.faceVertexUvs.push(T[4],T[5]))):g.length===4&&(S.indices.push(g[0],g[1],g[2]),S.indices.push(g[0],g[2],g[3]),T&&T.length===8&&(S.faceVertexUvs.push(T[0],T[1]),S.faceVertexUvs.push(T[2],T[3]),S.faceVertexUvs.push(T[4],T[5]),S.faceVertexUvs.push(T[0],T[1]),S.faceVertexUvs.push(T[4],T[5]),S.faceVertexUvs.push(T[6],T[7])));let{color:L}=w;if(L.usage){let P=a(L.type);ss.setRGB(M[L.names[0]]*P,M[L.names[1]]*P,M[L.names[2]]*P,Yn);let D=1/P,I=ss.r*D,U=ss.g*D,N=ss.b*D;S.faceVertexColors.push(I,U,N),S.faceVertexColors.push(I,U,N),S.faceVertexColors.push(I,U,N),g.length===4&&(S.faceVertexColors.push(I,U,N),S.faceVertexColors.push(I,U,N),S.faceVertexColors.push(I,U,N))}}}function d(S,b){let M={},w=0;for(let g=0;g<b.length;g++){let T=b[g],L=T.valueReader;if(T.type==="list"){let P=[],D=T.countReader.read(S+w);w+=T.countReader.size;for(let I=0;I<D;I++)P.push(L.read(S+w)),w+=L.size;M[T.name]=P}else M[T.name]=L.read(S+w),w+=L.size}return[M,w]}function x(S,b,M){function w(g,T,L){switch(T){case"int8":case"char":return{read:P=>g.getInt8(P),size:1};case"uint8":case"uchar":return{read:P=>g.getUint8(P),size:1};case"int16":case"short":return{read:P=>g.getInt16(P,L),size:2};case"uint16":case"ushort":return{read:P=>g.getUint16(P,L),size:2};case"int32":case"int":return{read:P=>g.getInt32(P,L),size:4};case"uint32":case"uint":return{read:P=>g.getUint32(P,L),size:4};case"float32":case"float":return{read:P=>g.getFloat32(P,L),size:4};case"float64":case"double":return{read:P=>g.getFloat64(P,L),size:8}}}for(let g=0,T=S.length;g<T;g++){let L=S[g];L.type==="list"?(L.countReader=w(b,L.countType,M),L.valueReader=w(b,L.itemType,M)):L.valueReader=w(b,L.type,M)}}function y(S,b){let M=r(),w=b.format==="binary_little_endian",g=new DataView(S,b.headerLength),T,L=0;for(let P=0;P<b.elements.length;P++){let D=b.elements[P],I=D.properties,U=c(I);M.descriptors[D.name]=U,x(I,g,w);for(let N=0;N<D.count;N++){T=d(L,I),L+=T[1];let G=T[0];f(M,D.name,G,U)}}return h(M)}function p(S){let b=0,M=!0,w="",g=[],T=new TextDecoder().decode(S.subarray(0,5)),L=/^ply\r\n/.test(T);do{let P=String.fromCharCode(S[b++]);P!==`
`&&P!=="\r"?w+=P:(w==="end_header"&&(M=!1),w!==""&&(g.push(w),w=""))}while(M&&b<S.length);return L===!0&&b++,{headerText:g.join("\r")+"\r",headerLength:b}}let m,_=this;if(e instanceof ArrayBuffer){let S=new Uint8Array(e),{headerText:b,headerLength:M}=p(S),w=t(b,M);if(w.format==="ascii"){let g=new TextDecoder().decode(S);m=u(g,w)}else m=y(e,w)}else m=u(e,t(e));return m}},Rp=class extends Ft{constructor(e,t,i){super(new Float64Array(e),t,i)}},Pp=class{constructor(e){this.arr=e,this.i=0}empty(){return this.i>=this.arr.length}next(){return this.arr[this.i++]}};function oo(n){for(var e=n.length/6|0,t=new Array(e),i=0;i<e;)t[i]="#"+n.slice(i*6,++i*6);return t}function Ma(n,e,t){n.prototype=e.prototype=t,t.constructor=n}function Wl(n,e){var t=Object.create(n.prototype);for(var i in e)t[i]=e[i];return t}function Er(){}var uo=.7,Sa=1/uo,ya="\\s*([+-]?\\d+)\\s*",Gl="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)\\s*",Ms="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)%\\s*",JE=/^#([0-9a-f]{3,8})$/,jE=new RegExp(`^rgb\\(${ya},${ya},${ya}\\)$`),ZE=new RegExp(`^rgb\\(${Ms},${Ms},${Ms}\\)$`),KE=new RegExp(`^rgba\\(${ya},${ya},${ya},${Gl}\\)$`),QE=new RegExp(`^rgba\\(${Ms},${Ms},${Ms},${Gl}\\)$`),eC=new RegExp(`^hsl\\(${Gl},${Ms},${Ms}\\)$`),tC=new RegExp(`^hsla\\(${Gl},${Ms},${Ms},${Gl}\\)$`),ov={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074};Ma(Er,Fh,{copy(n){return Object.assign(new this.constructor,this,n)},displayable(){return this.rgb().displayable()},hex:av,formatHex:av,formatHex8:nC,formatHsl:iC,formatRgb:lv,toString:lv});function av(){return this.rgb().formatHex()}function nC(){return this.rgb().formatHex8()}function iC(){return _v(this).formatHsl()}function lv(){return this.rgb().formatRgb()}function Fh(n){var e,t;return n=(n+"").trim().toLowerCase(),(e=JE.exec(n))?(t=e[1].length,e=parseInt(e[1],16),t===6?cv(e):t===3?new kn(e>>8&15|e>>4&240,e>>4&15|e&240,(e&15)<<4|e&15,1):t===8?Lh(e>>24&255,e>>16&255,e>>8&255,(e&255)/255):t===4?Lh(e>>12&15|e>>8&240,e>>8&15|e>>4&240,e>>4&15|e&240,((e&15)<<4|e&15)/255):null):(e=jE.exec(n))?new kn(e[1],e[2],e[3],1):(e=ZE.exec(n))?new kn(e[1]*255/100,e[2]*255/100,e[3]*255/100,1):(e=KE.exec(n))?Lh(e[1],e[2],e[3],e[4]):(e=QE.exec(n))?Lh(e[1]*255/100,e[2]*255/100,e[3]*255/100,e[4]):(e=eC.exec(n))?fv(e[1],e[2]/100,e[3]/100,1):(e=tC.exec(n))?fv(e[1],e[2]/100,e[3]/100,e[4]):ov.hasOwnProperty(n)?cv(ov[n]):n==="transparent"?new kn(NaN,NaN,NaN,0):null}function cv(n){return new kn(n>>16&255,n>>8&255,n&255,1)}function Lh(n,e,t,i){return i<=0&&(n=e=t=NaN),new kn(n,e,t,i)}function Fp(n){return n instanceof Er||(n=Fh(n)),n?(n=n.rgb(),new kn(n.r,n.g,n.b,n.opacity)):new kn}function Xl(n,e,t,i){return arguments.length===1?Fp(n):new kn(n,e,t,i??1)}function kn(n,e,t,i){this.r=+n,this.g=+e,this.b=+t,this.opacity=+i}Ma(kn,Xl,Wl(Er,{brighter(n){return n=n==null?Sa:Math.pow(Sa,n),new kn(this.r*n,this.g*n,this.b*n,this.opacity)},darker(n){return n=n==null?uo:Math.pow(uo,n),new kn(this.r*n,this.g*n,this.b*n,this.opacity)},rgb(){return this},clamp(){return new kn(lo(this.r),lo(this.g),lo(this.b),Nh(this.opacity))},displayable(){return-.5<=this.r&&this.r<255.5&&-.5<=this.g&&this.g<255.5&&-.5<=this.b&&this.b<255.5&&0<=this.opacity&&this.opacity<=1},hex:uv,formatHex:uv,formatHex8:sC,formatRgb:hv,toString:hv}));function uv(){return`#${ao(this.r)}${ao(this.g)}${ao(this.b)}`}function sC(){return`#${ao(this.r)}${ao(this.g)}${ao(this.b)}${ao((isNaN(this.opacity)?1:this.opacity)*255)}`}function hv(){let n=Nh(this.opacity);return`${n===1?"rgb(":"rgba("}${lo(this.r)}, ${lo(this.g)}, ${lo(this.b)}${n===1?")":`, ${n})`}`}function Nh(n){return isNaN(n)?1:Math.max(0,Math.min(1,n))}function lo(n){return Math.max(0,Math.min(255,Math.round(n)||0))}function ao(n){return n=lo(n),(n<16?"0":"")+n.toString(16)}function fv(n,e,t,i){return i<=0?n=e=t=NaN:t<=0||t>=1?n=e=NaN:e<=0&&(n=NaN),new rs(n,e,t,i)}function _v(n){if(n instanceof rs)return new rs(n.h,n.s,n.l,n.opacity);if(n instanceof Er||(n=Fh(n)),!n)return new rs;if(n instanceof rs)return n;n=n.rgb();var e=n.r/255,t=n.g/255,i=n.b/255,s=Math.min(e,t,i),r=Math.max(e,t,i),o=NaN,a=r-s,l=(r+s)/2;return a?(e===r?o=(t-i)/a+(t<i)*6:t===r?o=(i-e)/a+2:o=(e-t)/a+4,a/=l<.5?r+s:2-r-s,o*=60):a=l>0&&l<1?0:o,new rs(o,a,l,n.opacity)}function Uh(n,e,t,i){return arguments.length===1?_v(n):new rs(n,e,t,i??1)}function rs(n,e,t,i){this.h=+n,this.s=+e,this.l=+t,this.opacity=+i}Ma(rs,Uh,Wl(Er,{brighter(n){return n=n==null?Sa:Math.pow(Sa,n),new rs(this.h,this.s,this.l*n,this.opacity)},darker(n){return n=n==null?uo:Math.pow(uo,n),new rs(this.h,this.s,this.l*n,this.opacity)},rgb(){var n=this.h%360+(this.h<0)*360,e=isNaN(n)||isNaN(this.s)?0:this.s,t=this.l,i=t+(t<.5?t:1-t)*e,s=2*t-i;return new kn(Ip(n>=240?n-240:n+120,s,i),Ip(n,s,i),Ip(n<120?n+240:n-120,s,i),this.opacity)},clamp(){return new rs(dv(this.h),Dh(this.s),Dh(this.l),Nh(this.opacity))},displayable(){return(0<=this.s&&this.s<=1||isNaN(this.s))&&0<=this.l&&this.l<=1&&0<=this.opacity&&this.opacity<=1},formatHsl(){let n=Nh(this.opacity);return`${n===1?"hsl(":"hsla("}${dv(this.h)}, ${Dh(this.s)*100}%, ${Dh(this.l)*100}%${n===1?")":`, ${n})`}`}}));function dv(n){return n=(n||0)%360,n<0?n+360:n}function Dh(n){return Math.max(0,Math.min(1,n||0))}function Ip(n,e,t){return(n<60?e+(t-e)*n/60:n<180?t:n<240?e+(t-e)*(240-n)/60:e)*255}var xv=Math.PI/180,vv=180/Math.PI,Oh=18,yv=.96422,bv=1,Sv=.82521,Mv=4/29,ba=6/29,wv=3*ba*ba,rC=ba*ba*ba;function Tv(n){if(n instanceof ws)return new ws(n.l,n.a,n.b,n.opacity);if(n instanceof Ks)return Ev(n);n instanceof kn||(n=Fp(n));var e=Op(n.r),t=Op(n.g),i=Op(n.b),s=Lp((.2225045*e+.7168786*t+.0606169*i)/bv),r,o;return e===t&&t===i?r=o=s:(r=Lp((.4360747*e+.3850649*t+.1430804*i)/yv),o=Lp((.0139322*e+.0971045*t+.7141733*i)/Sv)),new ws(116*s-16,500*(r-s),200*(s-o),n.opacity)}function Av(n,e,t,i){return arguments.length===1?Tv(n):new ws(n,e,t,i??1)}function ws(n,e,t,i){this.l=+n,this.a=+e,this.b=+t,this.opacity=+i}Ma(ws,Av,Wl(Er,{brighter(n){return new ws(this.l+Oh*(n??1),this.a,this.b,this.opacity)},darker(n){return new ws(this.l-Oh*(n??1),this.a,this.b,this.opacity)},rgb(){var n=(this.l+16)/116,e=isNaN(this.a)?n:n+this.a/500,t=isNaN(this.b)?n:n-this.b/200;return e=yv*Dp(e),n=bv*Dp(n),t=Sv*Dp(t),new kn(Np(3.1338561*e-1.6168667*n-.4906146*t),Np(-.9787684*e+1.9161415*n+.033454*t),Np(.0719453*e-.2289914*n+1.4052427*t),this.opacity)}}));function Lp(n){return n>rC?Math.pow(n,1/3):n/wv+Mv}function Dp(n){return n>ba?n*n*n:wv*(n-Mv)}function Np(n){return 255*(n<=.0031308?12.92*n:1.055*Math.pow(n,1/2.4)-.055)}function Op(n){return(n/=255)<=.04045?n/12.92:Math.pow((n+.055)/1.055,2.4)}function oC(n){if(n instanceof Ks)return new Ks(n.h,n.c,n.l,n.opacity);if(n instanceof ws||(n=Tv(n)),n.a===0&&n.b===0)return new Ks(NaN,0<n.l&&n.l<100?0:NaN,n.l,n.opacity);var e=Math.atan2(n.b,n.a)*vv;return new Ks(e<0?e+360:e,Math.sqrt(n.a*n.a+n.b*n.b),n.l,n.opacity)}function Bh(n,e,t,i){return arguments.length===1?oC(n):new Ks(n,e,t,i??1)}function Ks(n,e,t,i){this.h=+n,this.c=+e,this.l=+t,this.opacity=+i}function Ev(n){if(isNaN(n.h))return new ws(n.l,0,0,n.opacity);var e=n.h*xv;return new ws(n.l,Math.cos(e)*n.c,Math.sin(e)*n.c,n.opacity)}Ma(Ks,Bh,Wl(Er,{brighter(n){return new Ks(this.h,this.c,this.l+Oh*(n??1),this.opacity)},darker(n){return new Ks(this.h,this.c,this.l-Oh*(n??1),this.opacity)},rgb(){return Ev(this).rgb()}}));var Cv=-.14861,Up=1.78277,Bp=-.29227,kh=-.90649,Hl=1.97294,pv=Hl*kh,mv=Hl*Up,gv=Up*Bp-kh*Cv;function aC(n){if(n instanceof co)return new co(n.h,n.s,n.l,n.opacity);n instanceof kn||(n=Fp(n));var e=n.r/255,t=n.g/255,i=n.b/255,s=(gv*i+pv*e-mv*t)/(gv+pv-mv),r=i-s,o=(Hl*(t-s)-Bp*r)/kh,a=Math.sqrt(o*o+r*r)/(Hl*s*(1-s)),l=a?Math.atan2(o,r)*vv-120:NaN;return new co(l<0?l+360:l,a,s,n.opacity)}function zh(n,e,t,i){return arguments.length===1?aC(n):new co(n,e,t,i??1)}function co(n,e,t,i){this.h=+n,this.s=+e,this.l=+t,this.opacity=+i}Ma(co,zh,Wl(Er,{brighter(n){return n=n==null?Sa:Math.pow(Sa,n),new co(this.h,this.s,this.l*n,this.opacity)},darker(n){return n=n==null?uo:Math.pow(uo,n),new co(this.h,this.s,this.l*n,this.opacity)},rgb(){var n=isNaN(this.h)?0:(this.h+120)*xv,e=+this.l,t=isNaN(this.s)?0:this.s*e*(1-e),i=Math.cos(n),s=Math.sin(n);return new kn(255*(e+t*(Cv*i+Up*s)),255*(e+t*(Bp*i+kh*s)),255*(e+t*(Hl*i)),this.opacity)}}));function Iv(n,e,t,i,s){var r=n*n,o=r*n;return((1-3*n+3*r-o)*e+(4-6*r+3*o)*t+(1+3*n+3*r-3*o)*i+o*s)/6}function lC(n){var e=n.length-1;return function(t){var i=t<=0?t=0:t>=1?(t=1,e-1):Math.floor(t*e),s=n[i],r=n[i+1],o=i>0?n[i-1]:2*s-r,a=i<e-1?n[i+2]:2*r-s;return Iv((t-i/e)*e,o,s,r,a)}}function cC(n){var e=n.length;return function(t){var i=Math.floor(((t%=1)<0?++t:t)*e),s=n[(i+e-1)%e],r=n[i%e],o=n[(i+1)%e],a=n[(i+2)%e];return Iv((t-i/e)*e,s,r,o,a)}}var zp=n=>()=>n;function Lv(n,e){return function(t){return n+t*e}}function uC(n,e,t){return n=Math.pow(n,t),e=Math.pow(e,t)-n,t=1/t,function(i){return Math.pow(n+i*e,t)}}function Vp(n,e){var t=e-n;return t?Lv(n,t>180||t<-180?t-360*Math.round(t/360):t):zp(isNaN(n)?e:n)}function hC(n){return(n=+n)==1?mi:function(e,t){return t-e?uC(e,t,n):zp(isNaN(e)?t:e)}}function mi(n,e){var t=e-n;return t?Lv(n,t):zp(isNaN(n)?e:n)}var tL=(function n(e){var t=hC(e);function i(s,r){var o=t((s=Xl(s)).r,(r=Xl(r)).r),a=t(s.g,r.g),l=t(s.b,r.b),c=mi(s.opacity,r.opacity);return function(u){return s.r=o(u),s.g=a(u),s.b=l(u),s.opacity=c(u),s+""}}return i.gamma=n,i})(1);function Dv(n){return function(e){var t=e.length,i=new Array(t),s=new Array(t),r=new Array(t),o,a;for(o=0;o<t;++o)a=Xl(e[o]),i[o]=a.r||0,s[o]=a.g||0,r[o]=a.b||0;return i=n(i),s=n(s),r=n(r),a.opacity=1,function(l){return a.r=i(l),a.g=s(l),a.b=r(l),a+""}}}var Nv=Dv(lC),nL=Dv(cC);function wa(n,e){return n=+n,e=+e,function(t){return n*(1-t)+e*t}}var fC=/[-+]?(?:\d+\.?\d*|\.?\d+)(?:[eE][-+]?\d+)?/g,iL=new RegExp(fC.source,"g");var Rv=180/Math.PI,kp={translateX:0,translateY:0,rotate:0,skewX:0,scaleX:1,scaleY:1};function Ov(n,e,t,i,s,r){var o,a,l;return(o=Math.sqrt(n*n+e*e))&&(n/=o,e/=o),(l=n*t+e*i)&&(t-=n*l,i-=e*l),(a=Math.sqrt(t*t+i*i))&&(t/=a,i/=a,l/=a),n*i<e*t&&(n=-n,e=-e,l=-l,o=-o),{translateX:s,translateY:r,rotate:Math.atan2(e,n)*Rv,skewX:Math.atan(l)*Rv,scaleX:o,scaleY:a}}var Vh;function dC(n){let e=new(typeof DOMMatrix=="function"?DOMMatrix:WebKitCSSMatrix)(n+"");return e.isIdentity?kp:Ov(e.a,e.b,e.c,e.d,e.e,e.f)}function pC(n){return n==null||(Vh||(Vh=document.createElementNS("http://www.w3.org/2000/svg","g")),Vh.setAttribute("transform",n),!(n=Vh.transform.baseVal.consolidate()))?kp:(n=n.matrix,Ov(n.a,n.b,n.c,n.d,n.e,n.f))}function Fv(n,e,t,i){function s(c){return c.length?c.pop()+" ":""}function r(c,u,h,f,d,x){if(c!==h||u!==f){var y=d.push("translate(",null,e,null,t);x.push({i:y-4,x:wa(c,h)},{i:y-2,x:wa(u,f)})}else(h||f)&&d.push("translate("+h+e+f+t)}function o(c,u,h,f){c!==u?(c-u>180?u+=360:u-c>180&&(c+=360),f.push({i:h.push(s(h)+"rotate(",null,i)-2,x:wa(c,u)})):u&&h.push(s(h)+"rotate("+u+i)}function a(c,u,h,f){c!==u?f.push({i:h.push(s(h)+"skewX(",null,i)-2,x:wa(c,u)}):u&&h.push(s(h)+"skewX("+u+i)}function l(c,u,h,f,d,x){if(c!==h||u!==f){var y=d.push(s(d)+"scale(",null,",",null,")");x.push({i:y-4,x:wa(c,h)},{i:y-2,x:wa(u,f)})}else(h!==1||f!==1)&&d.push(s(d)+"scale("+h+","+f+")")}return function(c,u){var h=[],f=[];return c=n(c),u=n(u),r(c.translateX,c.translateY,u.translateX,u.translateY,h,f),o(c.rotate,u.rotate,h,f),a(c.skewX,u.skewX,h,f),l(c.scaleX,c.scaleY,u.scaleX,u.scaleY,h,f),c=u=null,function(d){for(var x=-1,y=f.length,p;++x<y;)h[(p=f[x]).i]=p.x(d);return h.join("")}}}var sL=Fv(dC,"px, ","px)","deg)"),rL=Fv(pC,", ",")",")"),mC=1e-12;function Pv(n){return((n=Math.exp(n))+1/n)/2}function gC(n){return((n=Math.exp(n))-1/n)/2}function _C(n){return((n=Math.exp(2*n))-1)/(n+1)}var oL=(function n(e,t,i){function s(r,o){var a=r[0],l=r[1],c=r[2],u=o[0],h=o[1],f=o[2],d=u-a,x=h-l,y=d*d+x*x,p,m;if(y<mC)m=Math.log(f/c)/e,p=function(g){return[a+g*d,l+g*x,c*Math.exp(e*g*m)]};else{var _=Math.sqrt(y),S=(f*f-c*c+i*y)/(2*c*t*_),b=(f*f-c*c-i*y)/(2*f*t*_),M=Math.log(Math.sqrt(S*S+1)-S),w=Math.log(Math.sqrt(b*b+1)-b);m=(w-M)/e,p=function(g){var T=g*m,L=Pv(M),P=c/(t*_)*(L*_C(e*T+M)-gC(M));return[a+P*d,l+P*x,c*L/Pv(e*T+M)]}}return p.duration=Math.abs(m)*1e3*e/Math.SQRT2,p}return s.rho=function(r){var o=Math.max(.001,+r),a=o*o,l=a*a;return n(o,a,l)},s})(Math.SQRT2,2,4);function Uv(n){return function(e,t){var i=n((e=Uh(e)).h,(t=Uh(t)).h),s=mi(e.s,t.s),r=mi(e.l,t.l),o=mi(e.opacity,t.opacity);return function(a){return e.h=i(a),e.s=s(a),e.l=r(a),e.opacity=o(a),e+""}}}var aL=Uv(Vp),lL=Uv(mi);function Bv(n){return function(e,t){var i=n((e=Bh(e)).h,(t=Bh(t)).h),s=mi(e.c,t.c),r=mi(e.l,t.l),o=mi(e.opacity,t.opacity);return function(a){return e.h=i(a),e.c=s(a),e.l=r(a),e.opacity=o(a),e+""}}}var cL=Bv(Vp),uL=Bv(mi);function kv(n){return(function e(t){t=+t;function i(s,r){var o=n((s=zh(s)).h,(r=zh(r)).h),a=mi(s.s,r.s),l=mi(s.l,r.l),c=mi(s.opacity,r.opacity);return function(u){return s.h=o(u),s.s=a(u),s.l=l(Math.pow(u,t)),s.opacity=c(u),s+""}}return i.gamma=e,i})(1)}var hL=kv(Vp),fL=kv(mi);var zv=n=>Nv(n[n.length-1]);var Vv=new Array(3).concat("ef8a62f7f7f767a9cf","ca0020f4a58292c5de0571b0","ca0020f4a582f7f7f792c5de0571b0","b2182bef8a62fddbc7d1e5f067a9cf2166ac","b2182bef8a62fddbc7f7f7f7d1e5f067a9cf2166ac","b2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac","b2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac","67001fb2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac053061","67001fb2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac053061").map(oo),Gp=zv(Vv);function Hp(n){return n=Math.max(0,Math.min(1,n)),"rgb("+Math.max(0,Math.min(255,Math.round(-4.54-n*(35.34-n*(2381.73-n*(6402.7-n*(7024.72-n*2710.57)))))))+", "+Math.max(0,Math.min(255,Math.round(32.49+n*(170.73+n*(52.82-n*(131.46-n*(176.58-n*67.37)))))))+", "+Math.max(0,Math.min(255,Math.round(81.24+n*(442.36-n*(2482.43-n*(6167.24-n*(6614.94-n*2475.67)))))))+")"}function Gh(n){var e=n.length;return function(t){return n[Math.max(0,Math.min(e-1,Math.floor(t*e)))]}}var Wp=Gh(oo("44015444025645045745055946075a46085c460a5d460b5e470d60470e6147106347116447136548146748166848176948186a481a6c481b6d481c6e481d6f481f70482071482173482374482475482576482677482878482979472a7a472c7a472d7b472e7c472f7d46307e46327e46337f463480453581453781453882443983443a83443b84433d84433e85423f854240864241864142874144874045884046883f47883f48893e49893e4a893e4c8a3d4d8a3d4e8a3c4f8a3c508b3b518b3b528b3a538b3a548c39558c39568c38588c38598c375a8c375b8d365c8d365d8d355e8d355f8d34608d34618d33628d33638d32648e32658e31668e31678e31688e30698e306a8e2f6b8e2f6c8e2e6d8e2e6e8e2e6f8e2d708e2d718e2c718e2c728e2c738e2b748e2b758e2a768e2a778e2a788e29798e297a8e297b8e287c8e287d8e277e8e277f8e27808e26818e26828e26828e25838e25848e25858e24868e24878e23888e23898e238a8d228b8d228c8d228d8d218e8d218f8d21908d21918c20928c20928c20938c1f948c1f958b1f968b1f978b1f988b1f998a1f9a8a1e9b8a1e9c891e9d891f9e891f9f881fa0881fa1881fa1871fa28720a38620a48621a58521a68522a78522a88423a98324aa8325ab8225ac8226ad8127ad8128ae8029af7f2ab07f2cb17e2db27d2eb37c2fb47c31b57b32b67a34b67935b77937b87838b9773aba763bbb753dbc743fbc7340bd7242be7144bf7046c06f48c16e4ac16d4cc26c4ec36b50c46a52c56954c56856c66758c7655ac8645cc8635ec96260ca6063cb5f65cb5e67cc5c69cd5b6ccd5a6ece5870cf5773d05675d05477d1537ad1517cd2507fd34e81d34d84d44b86d54989d5488bd6468ed64590d74393d74195d84098d83e9bd93c9dd93ba0da39a2da37a5db36a8db34aadc32addc30b0dd2fb2dd2db5de2bb8de29bade28bddf26c0df25c2df23c5e021c8e020cae11fcde11dd0e11cd2e21bd5e21ad8e219dae319dde318dfe318e2e418e5e419e7e419eae51aece51befe51cf1e51df4e61ef6e620f8e621fbe723fde725")),xC=Gh(oo("00000401000501010601010802010902020b02020d03030f03031204041405041606051806051a07061c08071e0907200a08220b09240c09260d0a290e0b2b100b2d110c2f120d31130d34140e36150e38160f3b180f3d19103f1a10421c10441d11471e114920114b21114e22115024125325125527125829115a2a115c2c115f2d11612f116331116533106734106936106b38106c390f6e3b0f703d0f713f0f72400f74420f75440f764510774710784910784a10794c117a4e117b4f127b51127c52137c54137d56147d57157e59157e5a167e5c167f5d177f5f187f601880621980641a80651a80671b80681c816a1c816b1d816d1d816e1e81701f81721f817320817521817621817822817922827b23827c23827e24828025828125818326818426818627818827818928818b29818c29818e2a81902a81912b81932b80942c80962c80982d80992d809b2e7f9c2e7f9e2f7fa02f7fa1307ea3307ea5317ea6317da8327daa337dab337cad347cae347bb0357bb2357bb3367ab5367ab73779b83779ba3878bc3978bd3977bf3a77c03a76c23b75c43c75c53c74c73d73c83e73ca3e72cc3f71cd4071cf4070d0416fd2426fd3436ed5446dd6456cd8456cd9466bdb476adc4869de4968df4a68e04c67e24d66e34e65e44f64e55064e75263e85362e95462ea5661eb5760ec5860ed5a5fee5b5eef5d5ef05f5ef1605df2625df2645cf3655cf4675cf4695cf56b5cf66c5cf66e5cf7705cf7725cf8745cf8765cf9785df9795df97b5dfa7d5efa7f5efa815ffb835ffb8560fb8761fc8961fc8a62fc8c63fc8e64fc9065fd9266fd9467fd9668fd9869fd9a6afd9b6bfe9d6cfe9f6dfea16efea36ffea571fea772fea973feaa74feac76feae77feb078feb27afeb47bfeb67cfeb77efeb97ffebb81febd82febf84fec185fec287fec488fec68afec88cfeca8dfecc8ffecd90fecf92fed194fed395fed597fed799fed89afdda9cfddc9efddea0fde0a1fde2a3fde3a5fde5a7fde7a9fde9aafdebacfcecaefceeb0fcf0b2fcf2b4fcf4b6fcf6b8fcf7b9fcf9bbfcfbbdfcfdbf")),vC=Gh(oo("00000401000501010601010802010a02020c02020e03021004031204031405041706041907051b08051d09061f0a07220b07240c08260d08290e092b10092d110a30120a32140b34150b37160b39180c3c190c3e1b0c411c0c431e0c451f0c48210c4a230c4c240c4f260c51280b53290b552b0b572d0b592f0a5b310a5c320a5e340a5f3609613809623909633b09643d09653e0966400a67420a68440a68450a69470b6a490b6a4a0c6b4c0c6b4d0d6c4f0d6c510e6c520e6d540f6d550f6d57106e59106e5a116e5c126e5d126e5f136e61136e62146e64156e65156e67166e69166e6a176e6c186e6d186e6f196e71196e721a6e741a6e751b6e771c6d781c6d7a1d6d7c1d6d7d1e6d7f1e6c801f6c82206c84206b85216b87216b88226a8a226a8c23698d23698f24699025689225689326679526679727669827669a28659b29649d29649f2a63a02a63a22b62a32c61a52c60a62d60a82e5fa92e5eab2f5ead305dae305cb0315bb1325ab3325ab43359b63458b73557b93556ba3655bc3754bd3853bf3952c03a51c13a50c33b4fc43c4ec63d4dc73e4cc83f4bca404acb4149cc4248ce4347cf4446d04545d24644d34743d44842d54a41d74b3fd84c3ed94d3dda4e3cdb503bdd513ade5238df5337e05536e15635e25734e35933e45a31e55c30e65d2fe75e2ee8602de9612bea632aeb6429eb6628ec6726ed6925ee6a24ef6c23ef6e21f06f20f1711ff1731df2741cf3761bf37819f47918f57b17f57d15f67e14f68013f78212f78410f8850ff8870ef8890cf98b0bf98c0af98e09fa9008fa9207fa9407fb9606fb9706fb9906fb9b06fb9d07fc9f07fca108fca309fca50afca60cfca80dfcaa0ffcac11fcae12fcb014fcb216fcb418fbb61afbb81dfbba1ffbbc21fbbe23fac026fac228fac42afac62df9c72ff9c932f9cb35f8cd37f8cf3af7d13df7d340f6d543f6d746f5d949f5db4cf4dd4ff4df53f4e156f3e35af3e55df2e661f2e865f2ea69f1ec6df1ed71f1ef75f1f179f2f27df2f482f3f586f3f68af4f88ef5f992f6fa96f8fb9af9fc9dfafda1fcffa4")),yC=Gh(oo("0d088710078813078916078a19068c1b068d1d068e20068f2206902406912605912805922a05932c05942e05952f059631059733059735049837049938049a3a049a3c049b3e049c3f049c41049d43039e44039e46039f48039f4903a04b03a14c02a14e02a25002a25102a35302a35502a45601a45801a45901a55b01a55c01a65e01a66001a66100a76300a76400a76600a76700a86900a86a00a86c00a86e00a86f00a87100a87201a87401a87501a87701a87801a87a02a87b02a87d03a87e03a88004a88104a78305a78405a78606a68707a68808a68a09a58b0aa58d0ba58e0ca48f0da4910ea3920fa39410a29511a19613a19814a099159f9a169f9c179e9d189d9e199da01a9ca11b9ba21d9aa31e9aa51f99a62098a72197a82296aa2395ab2494ac2694ad2793ae2892b02991b12a90b22b8fb32c8eb42e8db52f8cb6308bb7318ab83289ba3388bb3488bc3587bd3786be3885bf3984c03a83c13b82c23c81c33d80c43e7fc5407ec6417dc7427cc8437bc9447aca457acb4679cc4778cc4977cd4a76ce4b75cf4c74d04d73d14e72d24f71d35171d45270d5536fd5546ed6556dd7566cd8576bd9586ada5a6ada5b69db5c68dc5d67dd5e66de5f65de6164df6263e06363e16462e26561e26660e3685fe4695ee56a5de56b5de66c5ce76e5be76f5ae87059e97158e97257ea7457eb7556eb7655ec7754ed7953ed7a52ee7b51ef7c51ef7e50f07f4ff0804ef1814df1834cf2844bf3854bf3874af48849f48948f58b47f58c46f68d45f68f44f79044f79143f79342f89441f89540f9973ff9983ef99a3efa9b3dfa9c3cfa9e3bfb9f3afba139fba238fca338fca537fca636fca835fca934fdab33fdac33fdae32fdaf31fdb130fdb22ffdb42ffdb52efeb72dfeb82cfeba2cfebb2bfebd2afebe2afec029fdc229fdc328fdc527fdc627fdc827fdca26fdcb26fccd25fcce25fcd025fcd225fbd324fbd524fbd724fad824fada24f9dc24f9dd25f8df25f8e125f7e225f7e425f6e626f6e826f5e926f5eb27f4ed27f3ee27f3f027f2f227f1f426f1f525f0f724f0f921"));function bC(n){let e=/^#(..)(..)(..)$/.exec(n),t=e?e.slice(1).map(i=>parseInt(i,16)):(n.match(/[\d.]+/g)??[]).map(Number);return[t[0]??0,t[1]??0,t[2]??0]}var Zn=256;function er(n){let e={viridis:Wp,cividis:Hp,blue_red:i=>Gp(1-i)}[n],t=new Uint8Array(4*Zn);for(let i=0;i<Zn;i++)t.set([...bC(e(i/(Zn-1))),255],4*i);return t}var Qs=[{name:"no outlier",color:[208,212,218]},{name:"too far away after registration",color:[230,159,0]},{name:"its neighbors map elsewhere",color:[0,114,178]},{name:"both",color:[213,94,0]},{name:"the target has nothing there",color:[86,60,92]}];function Gv(){let n=new Uint8Array(4*Zn);for(let e=0;e<Zn;e++){let t=Qs[Math.min(Qs.length-1,Math.floor(e/Zn*Qs.length))];n.set([...t?.color??[0,0,0],255],4*e)}return n}var Hv=([n,e,t])=>`rgb(${n}, ${e}, ${t})`,Wv=n=>(n+.5)/Qs.length;function Hh(n,e=[]){let t=new Ih,i=new TextDecoder().decode(n.slice(0,4096)).split("end_header")[0]??"",s=e.filter(a=>new RegExp(`^property \\w+ ${a}\\s*$`,"m").test(i));t.setCustomPropertyNameMapping(Object.fromEntries(s.map(a=>[a,[a]])));let r=t.parse(n),o={};for(let a of s)o[a]=Float32Array.from(r.getAttribute(a).array),r.deleteAttribute(a);return r.setAttribute("position",new Ft(Float32Array.from(r.getAttribute("position").array),3)),r.computeVertexNormals(),r.computeBoundingSphere(),{geometry:r,rows:o}}var SC=["target","confidence","inlier","spread_mm","outlier","triangle_0","triangle_1","triangle_2","barycentric_0","barycentric_1","barycentric_2"];async function Xv(n,e){let t=`v1/jobs/${n.id}`,i=async a=>(await si(`${t}/${a}`,{signal:e})).arrayBuffer(),[s,r,o]=await Promise.all([Ni(()=>Mt(`${t}/result?correspondences=false`,e),e),Ni(()=>i("correspondences?format=ply"),e),Ni(()=>i("surfaces/target?format=ply"),e)]);return{pair:MC(s,r,o),result:s}}function MC(n,e,t){let{geometry:i,rows:s}=Hh(e,SC),{geometry:r}=Hh(t),o=i.getAttribute("position").count,a=new Float32Array(o),l=I=>s[I]??a,[c,u]=[i.getAttribute("position"),r.getAttribute("position")],h=n.transform.matrix.flat(),f=new mt().set(...h),d=[l("triangle_0"),l("triangle_1"),l("triangle_2")],x=[l("barycentric_0"),l("barycentric_1"),l("barycentric_2")],y=new Float32Array(3*o),p=new Int32Array(o),m=l("outlier"),_={confidence:new Float32Array(o),residual:new Float32Array(o),displacement:new Float32Array(o),spread:new Float32Array(o),outlier:new Float32Array(o)},[S,b,M]=[new W,new W,i.getAttribute("normal")];for(let I=0;I<o;I++){let U=m[I]===4;for(let N=0;N<3;N++){let G=0;for(let Y=0;Y<3;Y++)G+=(x[Y]?.[I]??0)*u.getComponent(d[Y]?.[I]??0,N);y[3*I+N]=G}p[I]=U?-1:l("target")[I]??-1,S.fromBufferAttribute(c,I).applyMatrix4(f),b.fromBufferAttribute(M,I).transformDirection(f),S.set(y[3*I]-S.x,y[3*I+1]-S.y,y[3*I+2]-S.z),_.confidence[I]=U?NaN:l("confidence")[I]??NaN,_.spread[I]=U?NaN:l("spread_mm")[I]??NaN,_.residual[I]=U?NaN:S.length(),_.displacement[I]=U?NaN:S.dot(b),_.outlier[I]=Wv(m[I]??0)}let w=Object.fromEntries(Object.keys(_).map(I=>[I,wC(_[I],I==="outlier",d,x,p,r)])),g=u.count,T=new Uint32Array(g+1);p.forEach(I=>I>=0&&T[I+1]++);for(let I=0;I<g;I++)T[I+1]+=T[I];let L=T.slice(0,g),P=new Uint32Array(T[g]);p.forEach((I,U)=>I>=0&&(P[L[I]++]=U));let D=Uint8Array.from(l("inlier"));return{source:i,target:r,targetFromSource:f,images:y,nearest:p,inlier:D,columns:_,onTarget:w,starts:T,sources:P,frame:Ts(r)}}function wC(n,e,t,i,s,r){let o=r.getAttribute("position").count,a=new Float32Array(o).fill(NaN);if(e)s.forEach((c,u)=>c>=0&&(a[c]=Math.max(Number.isNaN(a[c])?0:a[c],n[u])));else{let[c,u]=[new Float64Array(o),new Float64Array(o)];for(let h=0;h<n.length;h++)if(!Number.isNaN(n[h]))for(let f=0;f<3;f++){let[d,x]=[t[f][h],i[f][h]];c[d]+=x*n[h],u[d]+=x}for(let h=0;h<o;h++)u[h]>1e-9&&(a[h]=c[h]/u[h])}let l=r.getIndex();for(let c=0;c<2;c++){let[u,h]=[new Float64Array(o),new Uint16Array(o)];for(let f=0;f<l.count;f+=3)for(let d=0;d<3;d++){let x=a[l.getX(f+d)];if(!Number.isNaN(x))for(let y=0;y<3;y++){let p=l.getX(f+y);u[p]=e?Math.max(u[p],x):u[p]+x,h[p]++}}for(let f=0;f<o;f++)Number.isNaN(a[f])&&h[f]>0&&(a[f]=e?u[f]:u[f]/h[f])}return a}function Ts(n){let e=n.getAttribute("position"),t=new W,i=new W;for(let h=0;h<e.count;h++)t.add(i.fromBufferAttribute(e,h));t.divideScalar(Math.max(1,e.count));let s=[0,0,0,0,0,0,0,0,0];for(let h=0;h<e.count;h++){let f=i.fromBufferAttribute(e,h).sub(t).toArray();for(let d=0;d<3;d++)for(let x=0;x<3;x++)s[3*d+x]+=f[d]*f[x]}let r=[1,0,0,0,1,0,0,0,1];for(let h=0;h<12;h++)for(let[f,d]of[[0,1],[0,2],[1,2]]){let x=s[3*f+d];if(Math.abs(x)<1e-12)continue;let y=.5*Math.atan2(2*x,s[3*d+d]-s[3*f+f]),[p,m]=[Math.cos(y),Math.sin(y)];for(let _=0;_<3;_++){let[S,b]=[s[3*_+f],s[3*_+d]];s[3*_+f]=p*S-m*b,s[3*_+d]=m*S+p*b}for(let _=0;_<3;_++){let[S,b]=[s[3*f+_],s[3*d+_]];s[3*f+_]=p*S-m*b,s[3*d+_]=m*S+p*b;let[M,w]=[r[3*_+f],r[3*_+d]];r[3*_+f]=p*M-m*w,r[3*_+d]=m*M+p*w}}let o=[0,1,2].sort((h,f)=>s[4*f]-s[4*h]),a=h=>new W(r[o[h]],r[3+o[h]],r[6+o[h]]).normalize(),[l,c]=[a(0),a(1)],u=[l,c,new W().crossVectors(l,c)];return qv(n,t,u)}function qv(n,e,t){let i=n.getAttribute("position"),[s,r]=[new W(1/0,1/0,1/0),new W(-1/0,-1/0,-1/0)],[o,a]=[new W,new W];for(let l=0;l<i.count;l++)o.fromBufferAttribute(i,l).sub(e),a.set(o.dot(t[0]),o.dot(t[1]),o.dot(t[2])),s.min(a),r.max(a);return{center:e,axes:t,low:s,high:r}}function $v(n,e){let t=Ts(e),[i,s]=[n.getAttribute("position"),e.getAttribute("position")];if(i.count!==s.count)return Ts(n);let r=new W,[o,a]=[new W,new W];for(let u=0;u<i.count;u++)r.add(o.fromBufferAttribute(i,u));r.divideScalar(Math.max(1,i.count));let l=[0,0,0,0,0,0,0,0,0];for(let u=0;u<i.count;u++){let[h,f]=[o.fromBufferAttribute(i,u).sub(r).toArray(),a.fromBufferAttribute(s,u).sub(t.center).toArray()];for(let d=0;d<3;d++)for(let x=0;x<3;x++)l[3*d+x]+=h[d]*f[x]}let c=new tt().set(...l);c.multiplyScalar(1/(Math.cbrt(Math.abs(c.determinant()))||1));for(let u=0;u<30;u++){let h=c.clone().invert().transpose();for(let f=0;f<9;f++)c.elements[f]=(c.elements[f]+h.elements[f])/2}return Math.abs(c.determinant()-1)<.01?qv(n,r,t.axes.map(u=>u.clone().applyMatrix3(c))):Ts(n)}function Xp(n,e,t){let i=e.length/3,s=new Float32Array(3*i),r=new W,o=Math.max(1e-9,n.high.x-n.low.x);for(let a=0;a<i;a++)r.set(e[3*a],e[3*a+1],e[3*a+2]).sub(n.center),s[3*a]=t(a)?(r.dot(n.axes[0])-n.low.x)/o:-1,s[3*a+1]=r.dot(n.axes[1]),s[3*a+2]=r.dot(n.axes[2]);return new Ft(s,3)}function Wh(n,e){let t=n.filter(i=>!Number.isNaN(i)).sort();return t[Math.min(t.length-1,Math.floor(e*t.length))]??1}var qp={type:"change"},Jp={type:"start"},jp={type:"end"},Xh=1e-6,Ct={NONE:-1,ROTATE:0,ZOOM:1,PAN:2,TOUCH_ROTATE:3,TOUCH_ZOOM_PAN:4},qh=new Ze,Cr=new Ze,TC=new W,$h=new W,$p=new W,Rr=new Sn,Yh=new W,Jh=new W,Yp=new W,jh=new W,Pr=class extends Rl{constructor(e,t=null){super(e,t),this.screen={left:0,top:0,width:0,height:0},this.rotateSpeed=1,this.zoomSpeed=1.2,this.panSpeed=.3,this.rollSpeed=1,this.noRotate=!1,this.noZoom=!1,this.noPan=!1,this.multiTouchRoll=!1,this.staticMoving=!1,this.dynamicDampingFactor=.2,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.keys=["KeyA","KeyS","KeyD"],this.mouseButtons={LEFT:wr.ROTATE,MIDDLE:wr.DOLLY,RIGHT:wr.PAN},this.target=new W,this.state=Ct.NONE,this.keyState=Ct.NONE,this._lastPosition=new W,this._lastUp=new W,this._lastZoom=1,this._touchZoomDistanceStart=0,this._touchZoomDistanceEnd=0,this._touchRollAngle=0,this._touchRollPointerIds="",this._lastAngle=0,this._lastRollAngle=0,this._eye=new W,this._movePrev=new Ze,this._moveCurr=new Ze,this._lastAxis=new W,this._zoomStart=new Ze,this._zoomEnd=new Ze,this._panStart=new Ze,this._panEnd=new Ze,this._pointers=[],this._pointerPositions={},this._onPointerMove=EC.bind(this),this._onPointerDown=AC.bind(this),this._onPointerUp=CC.bind(this),this._onPointerCancel=RC.bind(this),this._onContextMenu=FC.bind(this),this._onMouseWheel=OC.bind(this),this._onKeyDown=IC.bind(this),this._onKeyUp=PC.bind(this),this._onTouchStart=UC.bind(this),this._onTouchMove=BC.bind(this),this._onTouchEnd=kC.bind(this),this._onMouseDown=LC.bind(this),this._onMouseMove=DC.bind(this),this._onMouseUp=NC.bind(this),this._target0=this.target.clone(),this._position0=this.object.position.clone(),this._up0=this.object.up.clone(),this._zoom0=this.object.zoom,t!==null&&(this.connect(t),this.handleResize()),this.update()}connect(e){super.connect(e),window.addEventListener("keydown",this._onKeyDown),window.addEventListener("keyup",this._onKeyUp),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerCancel),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.style.touchAction="none"}disconnect(){window.removeEventListener("keydown",this._onKeyDown),window.removeEventListener("keyup",this._onKeyUp),this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerCancel),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.domElement.style.touchAction=""}dispose(){this.disconnect()}handleResize(){let e=this.domElement.getBoundingClientRect(),t=this.domElement.ownerDocument.documentElement;this.screen.left=e.left+window.pageXOffset-t.clientLeft,this.screen.top=e.top+window.pageYOffset-t.clientTop,this.screen.width=e.width,this.screen.height=e.height}update(){if(this._eye.subVectors(this.object.position,this.target),this.noRotate||(this._rotateCamera(),this.multiTouchRoll===!0&&this._rollCamera()),this.noZoom||this._zoomCamera(),this.noPan||this._panCamera(),this.object.position.addVectors(this.target,this._eye),this.object.isPerspectiveCamera){this._checkDistances(),this.object.lookAt(this.target);let e=this._lastPosition.distanceToSquared(this.object.position)>Xh,t=this._lastUp.distanceToSquared(this.object.up)>Xh;(e||t)&&(this.dispatchEvent(qp),this._lastPosition.copy(this.object.position),this._lastUp.copy(this.object.up))}else if(this.object.isOrthographicCamera){this.object.lookAt(this.target);let e=this._lastPosition.distanceToSquared(this.object.position)>Xh,t=this._lastUp.distanceToSquared(this.object.up)>Xh,i=this._lastZoom!==this.object.zoom;(e||t||i)&&(this.dispatchEvent(qp),this._lastPosition.copy(this.object.position),this._lastUp.copy(this.object.up),this._lastZoom=this.object.zoom)}else console.warn("THREE.TrackballControls: Unsupported camera type.")}reset(){this.state=Ct.NONE,this.keyState=Ct.NONE,this.target.copy(this._target0),this.object.position.copy(this._position0),this.object.up.copy(this._up0),this.object.zoom=this._zoom0,this.object.updateProjectionMatrix(),this._eye.subVectors(this.object.position,this.target),this.object.lookAt(this.target),this.dispatchEvent(qp),this._lastPosition.copy(this.object.position),this._lastUp.copy(this.object.up),this._lastZoom=this.object.zoom}_panCamera(){if(Cr.copy(this._panEnd).sub(this._panStart),Cr.lengthSq()){if(this.object.isOrthographicCamera){let e=(this.object.right-this.object.left)/this.object.zoom/this.domElement.clientWidth,t=(this.object.top-this.object.bottom)/this.object.zoom/this.domElement.clientWidth;Cr.x*=e,Cr.y*=t}Cr.multiplyScalar(this._eye.length()*this.panSpeed),$h.copy(this._eye).cross(this.object.up).setLength(Cr.x),$h.add(TC.copy(this.object.up).setLength(Cr.y)),this.object.position.add($h),this.target.add($h),this.staticMoving?this._panStart.copy(this._panEnd):this._panStart.add(Cr.subVectors(this._panEnd,this._panStart).multiplyScalar(this.dynamicDampingFactor))}}_rotateCamera(){jh.set(this._moveCurr.x-this._movePrev.x,this._moveCurr.y-this._movePrev.y,0);let e=jh.length();e?(this._eye.copy(this.object.position).sub(this.target),Yh.copy(this._eye).normalize(),Jh.copy(this.object.up).normalize(),Yp.crossVectors(Jh,Yh).normalize(),Jh.setLength(this._moveCurr.y-this._movePrev.y),Yp.setLength(this._moveCurr.x-this._movePrev.x),jh.copy(Jh.add(Yp)),$p.crossVectors(jh,this._eye).normalize(),e*=this.rotateSpeed,Rr.setFromAxisAngle($p,e),this._eye.applyQuaternion(Rr),this.object.up.applyQuaternion(Rr),this._lastAxis.copy($p),this._lastAngle=e):!this.staticMoving&&this._lastAngle&&(this._lastAngle*=Math.sqrt(1-this.dynamicDampingFactor),this._eye.copy(this.object.position).sub(this.target),Rr.setFromAxisAngle(this._lastAxis,this._lastAngle),this._eye.applyQuaternion(Rr),this.object.up.applyQuaternion(Rr)),this._movePrev.copy(this._moveCurr)}_rollCamera(){let e=this._getTouchRollAngle();if(e)this._lastRollAngle=e*this.rollSpeed;else if(!this.staticMoving&&this._lastRollAngle)this._lastRollAngle*=Math.sqrt(1-this.dynamicDampingFactor);else return;Yh.copy(this._eye).normalize(),Rr.setFromAxisAngle(Yh,this._lastRollAngle),this.object.up.applyQuaternion(Rr)}_getTouchRollAngle(){let e=this._pointers[0],t=this._pointers[1];if(t===void 0||e.pointerType!=="touch"||t.pointerType!=="touch")return this._touchRollPointerIds="",0;let i=`${e.pointerId},${t.pointerId}`,s=this._pointerPositions[e.pointerId],r=this._pointerPositions[t.pointerId],o=Math.atan2(r.y-s.y,r.x-s.x);if(i!==this._touchRollPointerIds)return this._touchRollPointerIds=i,this._touchRollAngle=o,0;let a=o-this._touchRollAngle;return this._touchRollAngle=o,a>Math.PI?a-=2*Math.PI:a<-Math.PI&&(a+=2*Math.PI),a}_zoomCamera(){let e;this.state===Ct.TOUCH_ZOOM_PAN?(e=this._touchZoomDistanceStart/this._touchZoomDistanceEnd,this._touchZoomDistanceStart=this._touchZoomDistanceEnd,this.object.isPerspectiveCamera?this._eye.multiplyScalar(e):this.object.isOrthographicCamera?(this.object.zoom=Th.clamp(this.object.zoom/e,this.minZoom,this.maxZoom),this._lastZoom!==this.object.zoom&&this.object.updateProjectionMatrix()):console.warn("THREE.TrackballControls: Unsupported camera type")):(e=1+(this._zoomEnd.y-this._zoomStart.y)*this.zoomSpeed,e!==1&&e>0&&(this.object.isPerspectiveCamera?this._eye.multiplyScalar(e):this.object.isOrthographicCamera?(this.object.zoom=Th.clamp(this.object.zoom/e,this.minZoom,this.maxZoom),this._lastZoom!==this.object.zoom&&this.object.updateProjectionMatrix()):console.warn("THREE.TrackballControls: Unsupported camera type")),this.staticMoving?this._zoomStart.copy(this._zoomEnd):this._zoomStart.y+=(this._zoomEnd.y-this._zoomStart.y)*this.dynamicDampingFactor)}_getMouseOnScreen(e,t){return qh.set((e-this.screen.left)/this.screen.width,(t-this.screen.top)/this.screen.height),qh}_getMouseOnCircle(e,t){return qh.set((e-this.screen.width*.5-this.screen.left)/(this.screen.width*.5),(this.screen.height+2*(this.screen.top-t))/this.screen.width),qh}_addPointer(e){this._pointers.push(e)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t].pointerId==e.pointerId){this._pointers.splice(t,1);return}}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ze,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0].pointerId?this._pointers[1]:this._pointers[0];return this._pointerPositions[t.pointerId]}_checkDistances(){(!this.noZoom||!this.noPan)&&(this._eye.lengthSq()>this.maxDistance*this.maxDistance&&(this.object.position.addVectors(this.target,this._eye.setLength(this.maxDistance)),this._zoomStart.copy(this._zoomEnd)),this._eye.lengthSq()<this.minDistance*this.minDistance&&(this.object.position.addVectors(this.target,this._eye.setLength(this.minDistance)),this._zoomStart.copy(this._zoomEnd)))}};function AC(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n))}function EC(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function CC(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchEnd(n):this._onMouseUp(),this._removePointer(n),this._pointers.length===0&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp)))}function RC(n){this._removePointer(n)}function PC(){this.enabled!==!1&&(this.keyState=Ct.NONE,window.addEventListener("keydown",this._onKeyDown))}function IC(n){this.enabled!==!1&&(window.removeEventListener("keydown",this._onKeyDown),this.keyState===Ct.NONE&&(n.code===this.keys[Ct.ROTATE]&&!this.noRotate?this.keyState=Ct.ROTATE:n.code===this.keys[Ct.ZOOM]&&!this.noZoom?this.keyState=Ct.ZOOM:n.code===this.keys[Ct.PAN]&&!this.noPan&&(this.keyState=Ct.PAN)))}function LC(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case wr.DOLLY:this.state=Ct.ZOOM;break;case wr.ROTATE:this.state=Ct.ROTATE;break;case wr.PAN:this.state=Ct.PAN;break;default:this.state=Ct.NONE}let t=this.keyState!==Ct.NONE?this.keyState:this.state;t===Ct.ROTATE&&!this.noRotate?(this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY)),this._movePrev.copy(this._moveCurr)):t===Ct.ZOOM&&!this.noZoom?(this._zoomStart.copy(this._getMouseOnScreen(n.pageX,n.pageY)),this._zoomEnd.copy(this._zoomStart)):t===Ct.PAN&&!this.noPan&&(this._panStart.copy(this._getMouseOnScreen(n.pageX,n.pageY)),this._panEnd.copy(this._panStart)),this.dispatchEvent(Jp)}function DC(n){let e=this.keyState!==Ct.NONE?this.keyState:this.state;e===Ct.ROTATE&&!this.noRotate?this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY)):e===Ct.ZOOM&&!this.noZoom?this._zoomEnd.copy(this._getMouseOnScreen(n.pageX,n.pageY)):e===Ct.PAN&&!this.noPan&&this._panEnd.copy(this._getMouseOnScreen(n.pageX,n.pageY))}function NC(){this.state=Ct.NONE,this.dispatchEvent(jp)}function OC(n){if(this.enabled!==!1&&this.noZoom!==!0){switch(n.preventDefault(),n.deltaMode){case 2:this._zoomStart.y-=n.deltaY*.025;break;case 1:this._zoomStart.y-=n.deltaY*.01;break;default:this._zoomStart.y-=n.deltaY*25e-5;break}this.dispatchEvent(Jp),this.dispatchEvent(jp)}}function FC(n){this.enabled!==!1&&n.preventDefault()}function UC(n){if(this._trackPointer(n),this._pointers.length===1)this.state=Ct.TOUCH_ROTATE,this._moveCurr.copy(this._getMouseOnCircle(this._pointers[0].pageX,this._pointers[0].pageY)),this._movePrev.copy(this._moveCurr);else{this.state=Ct.TOUCH_ZOOM_PAN;let e=this._pointers[0].pageX-this._pointers[1].pageX,t=this._pointers[0].pageY-this._pointers[1].pageY;this._touchZoomDistanceEnd=this._touchZoomDistanceStart=Math.sqrt(e*e+t*t);let i=(this._pointers[0].pageX+this._pointers[1].pageX)/2,s=(this._pointers[0].pageY+this._pointers[1].pageY)/2;this._panStart.copy(this._getMouseOnScreen(i,s)),this._panEnd.copy(this._panStart)}this.dispatchEvent(Jp)}function BC(n){if(this._trackPointer(n),this._pointers.length===1)this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY));else{let e=this._getSecondPointerPosition(n),t=n.pageX-e.x,i=n.pageY-e.y;this._touchZoomDistanceEnd=Math.sqrt(t*t+i*i);let s=(n.pageX+e.x)/2,r=(n.pageY+e.y)/2;this._panEnd.copy(this._getMouseOnScreen(s,r))}}function kC(n){switch(this._pointers.length){case 0:this.state=Ct.NONE;break;case 1:this.state=Ct.TOUCH_ROTATE,this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY)),this._movePrev.copy(this._moveCurr);break;case 2:this.state=Ct.TOUCH_ZOOM_PAN;for(let e=0;e<this._pointers.length;e++)if(this._pointers[e].pointerId!==n.pointerId){let t=this._pointerPositions[this._pointers[e].pointerId];this._moveCurr.copy(this._getMouseOnCircle(t.x,t.y)),this._movePrev.copy(this._moveCurr);break}break}this.dispatchEvent(jp)}var zC=`
  attribute float value;
  attribute vec3 place;
  uniform mat4 pose;
  varying float vValue;
  varying vec3 vPlace;
  varying vec3 vNormal;
  varying vec3 vPosed;
  void main() {
    vValue = value;
    vPlace = place;
    vNormal = normalMatrix * normal;
    vPosed = (pose * vec4(position, 1.0)).xyz;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`,VC=`
  uniform sampler2D map;
  uniform float low;
  uniform float top;
  uniform float opacity;
  uniform bool byPlace;
  uniform bool grid;
  uniform vec4 section;
  varying float vValue;
  varying vec3 vPlace;
  varying vec3 vNormal;
  varying vec3 vPosed;
  float line(float at) {
    float width = fwidth(at);
    float off = abs(fract(at - 0.5) - 0.5);
    return width > 0.4 ? 0.0 : 1.0 - smoothstep(width, 2.0 * width, off);
  }
  void main() {
    if (dot(vPosed, section.xyz) > section.w) discard;
    float at = byPlace ? vPlace.x : (vValue - low) / (top - low);
    bool isKnown = byPlace ? vPlace.x > -0.001 : vValue > -1e8;
    vec3 color = !isKnown ? vec3(0.62, 0.64, 0.66) : texture2D(map, vec2(clamp(at, 0.002, 0.998), 0.5)).rgb;
    if (grid && vPlace.x > -0.5) {
      float around = atan(vPlace.z, vPlace.y) * 1.2732395;
      float cut = abs(vPlace.z) < 1e-6 ? 0.0 : 1.0;
      float lines = max(line(vPlace.x * 12.0), fwidth(around) > 1.0 ? 0.0 : cut * line(around));
      color *= 1.0 - 0.55 * lines;
    }
    float light = 0.42 + 0.58 * abs(normalize(vNormal).z);
    if (!gl_FrontFacing) color = mix(color, vec3(0.45), 0.6);
    gl_FragColor = vec4(color * light, opacity);
  }`,Zp=new kt(0,0,0,1);function Zh(n){let e={map:{value:n},low:{value:0},top:{value:1},opacity:{value:1},byPlace:{value:!0},grid:{value:!0},section:{value:Zp.clone()},pose:{value:new mt}};return new zi({vertexShader:zC,fragmentShader:VC,uniforms:e,side:di})}var GC=240,Kp=64,HC=45,Yv=250,Qp=56;function WC(n){n.computeBoundingBox();let{min:e,max:t}=n.boundingBox,i=Math.max(t.x-e.x,t.y-e.y,t.z-e.z,1e-9)/Qp,s=n.getAttribute("position"),r=new Map,o=new Uint32Array(s.count);for(let c=0;c<s.count;c++){let[u,h,f]=[(s.getX(c)-e.x)/i,(s.getY(c)-e.y)/i,(s.getZ(c)-e.z)/i].map(Math.floor),d=(u*(Qp+1)+h)*(Qp+1)+f,x=r.get(d);x===void 0&&r.set(d,c),o[c]=x??c}let a=n.getIndex(),l=[];for(let c=0;c<a.count;c+=3){let[u,h,f]=[o[a.getX(c)],o[a.getX(c+1)],o[a.getX(c+2)]];u!==h&&h!==f&&u!==f&&l.push(u,h,f)}return new Ft(Uint32Array.from(l),1)}var Kh=class{constructor(e,t,i){this.canvas=e;this.pair=t;this.look=i,this.renderer=new Ss({canvas:e,antialias:!0,alpha:!1}),this.renderer.setPixelRatio(Math.min(2,window.devicePixelRatio)),this.renderer.autoClear=!1;let s=p=>{let m=new $s(p,Zn,1);return m.needsUpdate=!0,m};this.maps={viridis:s(er("viridis")),cividis:s(er("cividis")),outlier:s(Gv())};let{frame:r}=t,o=t.target.getAttribute("position").array;t.target.setAttribute("place",Xp(r,o,()=>!0)),t.source.setAttribute("place",Xp(r,t.images,p=>t.nearest[p]>=0)),this.indices={source:{whole:t.source.getIndex()},target:{whole:t.target.getIndex()}},this.meshes={source:this.surface(t.source),target:this.surface(t.target)};let a=Math.max(1e-6,r.high.x-r.low.x),l=new yr(a*.009,16,12);this.marks={source:this.marksOf(l),target:this.marksOf(l)},this.halos={source:this.halo(),target:this.halo()};for(let p of["source","target"])this.groups[p].add(this.meshes[p],this.marks[p],this.halos[p]),this.scene.add(this.groups[p]);this.radius=t.target.boundingSphere.radius;let c=t.source.boundingSphere.center.clone();this.centers={source:c,moved:c.clone().applyMatrix4(t.targetFromSource)};let u=[];t.inlier.forEach((p,m)=>p&&t.nearest[m]>=0&&u.push(m));let h=Math.max(1,Math.floor(u.length/GC));this.lineRows=u.filter((p,m)=>m%h===0);let f=new Jn;f.setAttribute("position",new Ft(new Float32Array(6*this.lineRows.length),3)),this.lines=new _l(f,new ua({transparent:!0,opacity:.55,depthTest:!1})),this.lines.frustumCulled=!1,this.scene.add(this.lines),this.controls=new Pr(this.camera,e),this.controls.staticMoving=!0,this.controls.rotateSpeed=3,this.controls.zoomSpeed=1.4,this.controls.addEventListener("change",()=>this.redraw()),this.view(),this.set(i),this.sizes.observe(e);let d=0,x=0,y=p=>{this.waiting=requestAnimationFrame(y),this.controls.update();let m=p-d;d=p,this.isDirty?(p-x<1e3&&x>0&&m>HC&&(this.isSlow=!0),this.detail(!(this.isSlow&&p-x<Yv)),x=p,this.draw()):!this.isWhole&&p-x>Yv&&(this.detail(!0),this.draw())};y(performance.now())}canvas;pair;renderer;camera=new Pi(-1,1,1,-1,-1e3,1e3);controls;scene=new es;groups={source:new _s,target:new _s};meshes;marks;halos;lines;lineRows;pose=new mt;centers;maps;sizes=new ResizeObserver(()=>this.resize());look;isSlow=!1;isWhole=!0;indices;waiting=0;isDirty=!0;radius;dispose(){cancelAnimationFrame(this.waiting),this.sizes.disconnect(),this.controls.dispose(),this.renderer.dispose(),this.pair.source.dispose(),this.pair.target.dispose()}surface(e){e.setAttribute("value",new Ft(new Float32Array(e.getAttribute("position").count),1));let t=Zh(this.maps.viridis),i=new Mn(e,t);return i.matrixAutoUpdate=!1,i}detail(e){if(e!==this.isWhole){this.isWhole=e;for(let t of["source","target"]){let i=this.indices[t];i.coarse??=WC(this.pair[t]),this.pair[t].setIndex(e?i.whole:i.coarse)}}}marksOf(e){let t=new gl(e,new qs({color:16723349,depthTest:!1}),Kp);return t.count=0,t.renderOrder=3,t.frustumCulled=!1,t}halo(){let e=new Mn(new yr(1,32,24),new qs({color:16723349,transparent:!0,opacity:.28,depthTest:!1}));return e.visible=!1,e.renderOrder=2,e}view(){let{center:e,axes:t}=this.pair.frame;this.controls.target.copy(e),this.camera.up.copy(t[1]),this.camera.position.copy(e).addScaledVector(t[2],4*this.radius),this.camera.near=-20*this.radius,this.camera.far=40*this.radius,this.camera.zoom=1,this.camera.lookAt(e),this.resize()}turn(e,t){let i=this.camera.position.clone().sub(this.controls.target),s=new W().crossVectors(this.camera.up,i).normalize(),r=new Sn().setFromAxisAngle(this.camera.up.clone().normalize(),e);r.premultiply(new Sn().setFromAxisAngle(s,t)),i.applyQuaternion(r),this.camera.up.applyQuaternion(r).normalize(),this.camera.position.copy(this.controls.target).add(i),this.camera.lookAt(this.controls.target),this.redraw()}zoom(e){this.camera.zoom=Math.min(40,Math.max(.2,this.camera.zoom*e)),this.camera.updateProjectionMatrix(),this.redraw()}set(e){let{pair:t}=this;this.look=e;let i=e.coloring==="outlier"?this.maps.outlier:this.maps[e.map];for(let r of["source","target"]){let{uniforms:o}=this.meshes[r].material;if(o.map.value=i,o.byPlace.value=e.coloring==="correspondence",o.grid.value=e.grid&&e.coloring==="correspondence",o.low.value=e.coloring==="displacement"?-e.top:0,o.top.value=e.coloring==="outlier"?1:Math.max(1e-9,e.top),e.coloring!=="correspondence"){let a=r==="source"?t.columns[e.coloring]:t.onTarget[e.coloring],l=this.meshes[r].geometry.getAttribute("value");for(let c=0;c<a.length;c++)l.array[c]=Number.isNaN(a[c])?-1e9:a[c];l.needsUpdate=!0}}let s=this.meshes.source.material;s.transparent=e.overlay&&e.opacity<1,s.depthWrite=!s.transparent,s.uniforms.opacity.value=e.overlay?e.opacity:1,this.meshes.source.renderOrder=1,this.move(),this.resize()}move(){let[e,t,i]=[new W,new Sn,new W];this.pair.targetFromSource.decompose(e,t,i);let s=this.look.pose,r=new Sn().slerp(t,s),o=new W(1,1,1).lerp(i,s),a=this.centers.source.clone().lerp(this.centers.moved,s),l=new mt().compose(new W,r,o);e.copy(a).sub(this.centers.source.clone().applyMatrix4(l)),this.pose.compose(e,r,o),this.meshes.source.matrix.copy(s===1?this.pair.targetFromSource:this.pose),this.pose.copy(this.meshes.source.matrix),this.meshes.source.material.uniforms.pose.value.copy(this.pose),this.redraw()}isStacked(){return this.canvas.clientWidth<1.25*this.canvas.clientHeight}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;if(e===0||t===0)return;this.renderer.setSize(e,t,!1);let i=this.look.overlay?1:2,s=this.isStacked(),[r,o]=[s?e:e/i,s?t/i:t],{low:a,high:l}=this.pair.frame,[c,u]=[2.2*Math.max(-a.x,l.x),2.3*Math.max(-a.y,l.y,-a.z,l.z)];if(this.look.overlay){let f=this.centers.source.distanceTo(this.centers.moved)*(1-this.look.pose),d=2*f+(f>0?this.radius:0);[c,u]=[c+d,u+d]}let h=Math.max(c/r,u/o);this.camera.left=-e*h/2,this.camera.right=e*h/2,this.camera.top=t*h/2,this.camera.bottom=-t*h/2,this.camera.updateProjectionMatrix(),this.controls.handleResize(),this.redraw()}redraw(){this.isDirty=!0}arrange(){this.camera.updateMatrixWorld();let e=new W().setFromMatrixColumn(this.camera.matrixWorld,0),t=new W().setFromMatrixColumn(this.camera.matrixWorld,1),{source:i,target:s}=this.groups;if(i.position.set(0,0,0),s.position.set(0,0,0),!this.look.overlay){let o=this.isStacked(),a=(o?this.camera.top-this.camera.bottom:this.camera.right-this.camera.left)/this.camera.zoom/4,l=o?t.negate():e;i.position.addScaledVector(l,-a),s.position.addScaledVector(l,a);let c=this.centers.source.clone().applyMatrix4(this.pose);i.position.sub(c).add(this.centers.moved)}let r=new kt().copy(Zp);if(this.look.section!==null){let o=new W().setFromMatrixColumn(this.camera.matrixWorld,2),a=this.pair.frame.center.dot(o)+this.radius*(1-2*this.look.section);r.set(o.x,o.y,o.z,a)}for(let o of["source","target"])this.meshes[o].material.uniforms.section.value.copy(r);if(this.lines.visible=this.look.lines,this.look.lines){let o=this.lines.geometry.getAttribute("position"),[a,l]=[this.pair.source.getAttribute("position"),new W];this.lineRows.forEach((c,u)=>{l.fromBufferAttribute(a,c).applyMatrix4(this.pose).add(i.position),o.setXYZ(2*u,l.x,l.y,l.z),l.fromArray(this.pair.images,3*c).add(s.position),o.setXYZ(2*u+1,l.x,l.y,l.z)}),o.needsUpdate=!0}this.scene.updateMatrixWorld()}draw(){this.isDirty=!1;let{renderer:e,canvas:t}=this,{clientWidth:i,clientHeight:s}=t;if(i===0||s===0)return;this.arrange();let r=getComputedStyle(t);if(e.setClearColor(new it(r.getPropertyValue("--canvas").trim()||"#f4f6f8")),this.lines.material.color.set(r.getPropertyValue("--line").trim()||"#333333"),e.setScissorTest(!1),e.clear(),this.look.overlay){e.render(this.scene,this.camera);return}let{source:o,target:a}=this.groups,l=this.lines.visible,c=this.isStacked();this.lines.visible=!1,e.setScissorTest(!0);for(let[u,h,f]of[[o,a,0],[a,o,1]])u.visible=!0,h.visible=!1,c?e.setScissor(0,f===0?s/2:0,i,s/2):e.setScissor(f*i/2,0,i/2,s),e.render(this.scene,this.camera);e.setScissorTest(!1),o.visible=a.visible=!0,l&&(o.visible=a.visible=!1,this.lines.visible=!0,e.render(this.scene,this.camera),o.visible=a.visible=!0)}pick(e,t){this.detail(!0);let{clientWidth:i,clientHeight:s}=this.canvas;this.arrange();let r=new eo;r.setFromCamera(new Ze(2*e/i-1,1-2*t/s),this.camera);let o=["source","target"];this.look.overlay||(o=[(this.isStacked()?t>s/2:e>i/2)?"target":"source"]);let a=this.meshes.target.material.uniforms.section.value,l=(_,S)=>S.clone().sub(this.groups[_].position).dot(new W(a.x,a.y,a.z))>a.w,u=o.flatMap(_=>r.intersectObject(this.meshes[_]).map(S=>({side:_,hit:S}))).filter(({side:_,hit:S})=>!l(_,S.point)).sort((_,S)=>_.hit.distance-S.hit.distance)[0];if(u===void 0||!u.hit.face)return null;let{side:h,hit:f}=u,d=this.meshes[h].worldToLocal(f.point.clone()),x=[f.face.a,f.face.b,f.face.c],y=this.meshes[h].geometry.getAttribute("position"),p=_=>d.distanceToSquared(new W().fromBufferAttribute(y,_)),m=x.reduce((_,S)=>p(S)<p(_)?S:_);return this.describe(h,m)}describe(e,t){let{pair:i}=this;if(e==="source")return{side:e,vertex:t,others:[i.nearest[t]],spread_mm:i.columns.spread[t]};let s=[...i.sources.slice(i.starts[t],i.starts[t+1])],r=s.map(o=>i.columns.spread[o]).filter(o=>!Number.isNaN(o));return{side:e,vertex:t,others:s,spread_mm:r.length>0?Math.max(...r):NaN}}mark(e){for(let t of["source","target"])this.marks[t].count=0,this.halos[t].visible=!1;if(e!==null){let{pair:t}=this,i=(a,l)=>new W().fromBufferAttribute(t[a].getAttribute("position"),l).applyMatrix4(a==="source"?this.pose:new mt),s=(a,l)=>{l.slice(0,Kp).forEach((c,u)=>this.marks[a].setMatrixAt(u,new mt().makeTranslation(c.x,c.y,c.z))),this.marks[a].count=Math.min(Kp,l.length),this.marks[a].instanceMatrix.needsUpdate=!0};s(e.side,[i(e.side,e.vertex)]);let r=e.side==="source"?"target":"source",o;if(e.side==="source"?o=e.others[0]<0?[]:[new W().fromArray(t.images,3*e.vertex)]:o=e.others.map(a=>i("source",a)),s(r,o),o.length>0&&e.spread_mm>0){let a=o.reduce((l,c)=>l.add(c),new W).divideScalar(o.length);this.halos[r].position.copy(a),this.halos[r].scale.setScalar(e.spread_mm),this.halos[r].visible=!0}}this.redraw()}project(e,t){this.arrange();let{geometry:i,matrixWorld:s}=this.meshes[e],r=new W().fromBufferAttribute(i.getAttribute("position"),t).applyMatrix4(s),o=new W().fromBufferAttribute(i.getAttribute("normal"),t).transformDirection(s),a=new W().setFromMatrixColumn(this.camera.matrixWorld,2);r.project(this.camera);let{clientWidth:l,clientHeight:c}=this.canvas;return{x:(r.x+1)/2*l,y:(1-r.y)/2*c,facing:o.dot(a)}}frameTimes(e,t){this.detail(t);let i=this.renderer.getContext(),s=new Uint8Array(4);return Array.from({length:e},()=>{let r=performance.now();return this.turn(.05,.01),this.draw(),i.readPixels(0,0,1,1,i.RGBA,i.UNSIGNED_BYTE,s),performance.now()-r})}picture(){return this.draw(),new Promise(e=>this.canvas.toBlob(e,"image/png"))}};var Jv=[{name:"correspondence",label:"Correspondence",help:"The target is colored along its length, with a grid; each source vertex has the color and the grid of its corresponding point. Where colors jump or the grid breaks, the match is wrong.",unit:""},{name:"confidence",label:"Confidence",help:"Probability that the corresponding point is right to within one edge of the target.",unit:""},{name:"residual",label:"Residual",help:"Distance of each vertex, moved rigidly, from its corresponding point: how far the rest of the match has to bend the source.",unit:"mm"},{name:"displacement",label:"Displacement",help:"The part of it along the outward normal: the target lies inside of the source where it is negative (dark), outside where it is positive (light).",unit:"mm"},{name:"spread",label:"Spread",help:"Expected error of the corresponding point.",unit:"mm"},{name:"outlier",label:"Outliers",help:"Vertices that do not follow the transform or their neighbors, and why.",unit:""}];function XC({map:n,low:e,high:t,label:i}){let s=tn(null);return xt(()=>{s.current?.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(er(n)),Zn,1),0,0)},[n]),v("div",{class:"scale",children:[v("span",{children:e}),v("canvas",{ref:s,width:Zn,height:1,role:"img","aria-label":i}),v("span",{children:t})]})}function jv({job:n,pair:e}){let t=tn(null),i=tn(null),[s,r]=pe(null),[o,a]=pe(null),[l,c]=pe({coloring:"correspondence",map:"viridis",top:1,grid:!0,overlay:!1,pose:1,lines:!1,section:null,opacity:.6}),u=ii(()=>{let _=S=>Wh(e.columns[S].map(Math.abs),.95)||1;return{correspondence:1,confidence:1,outlier:1,residual:_("residual"),displacement:_("displacement"),spread:_("spread")}},[e]),h=_=>c(S=>{let b={...S,..._};return{...b,top:u[b.coloring]}});xt(()=>{let _;try{_=new Kh(t.current,e,l)}catch{r("This browser cannot draw in 3D (WebGL 2 is not available). The surfaces can be saved below and opened in another program.");return}return i.current=_,t.current.scene=_,()=>{_.dispose(),i.current=null}},[e]),xt(()=>i.current?.set(l),[l,e]);let f=qr();xt(()=>i.current?.redraw(),[f]);let d=_=>{if(_.buttons!==0)return;let S=t.current.getBoundingClientRect(),b=i.current?.pick(_.clientX-S.left,_.clientY-S.top)??null;i.current?.mark(b),a(b)},x=()=>{i.current?.mark(null),a(null)},y=_=>{let b={ArrowLeft:[-.12,0],ArrowRight:[.12,0],ArrowUp:[0,-.12],ArrowDown:[0,.12]}[_.key];if(b)i.current?.turn(...b);else if(_.key==="+"||_.key==="=")i.current?.zoom(1.2);else if(_.key==="-")i.current?.zoom(1/1.2);else if(_.key==="Home")i.current?.view();else return;_.preventDefault()},p=Jv.find(({name:_})=>_===l.coloring),m=e.columns;return v("section",{class:"viewer","aria-label":"The match in 3D",children:[v("div",{class:"tools",children:[v("label",{children:["Color"," ",v("select",{value:l.coloring,onChange:_=>h({coloring:_.currentTarget.value}),children:Jv.map(({name:_,label:S})=>v("option",{value:_,children:S}))})]}),v("label",{children:["Map"," ",v("select",{value:l.map,onChange:_=>h({map:_.currentTarget.value}),children:[v("option",{value:"viridis",children:"viridis"}),v("option",{value:"cividis",children:"cividis"})]})]}),v("div",{class:"choice",role:"group","aria-label":"Arrangement",children:[v("button",{"aria-pressed":!l.overlay,onClick:()=>h({overlay:!1}),children:"Side by side"}),v("button",{"aria-pressed":l.overlay,onClick:()=>h({overlay:!0}),children:"Overlaid"})]}),v("label",{class:"slider",children:["Pose: original"," ",v("input",{type:"range",min:0,max:1,step:.01,value:l.pose,"aria-label":"Pose, from original to aligned",onInput:_=>h({pose:Number(_.currentTarget.value)})})," aligned"]}),l.overlay&&v("label",{class:"slider",children:["Source"," ",v("input",{type:"range",min:.15,max:1,step:.05,value:l.opacity,"aria-label":"Opacity of the source",onInput:_=>h({opacity:Number(_.currentTarget.value)})})]}),l.coloring==="correspondence"&&v(Ns,{label:"Grid",checked:l.grid,onChange:_=>h({grid:_.currentTarget.checked})}),v(Ns,{label:"Inlier lines",checked:l.lines,onChange:_=>h({lines:_.currentTarget.checked})}),v(Ns,{label:"Section",checked:l.section!==null,onChange:_=>h({section:_.currentTarget.checked?.4:null})}),l.section!==null&&v("input",{type:"range",min:.02,max:.98,step:.01,value:l.section,"aria-label":"Depth of the section",onInput:_=>h({section:Number(_.currentTarget.value)})}),v("span",{class:"group",children:[v("button",{onClick:()=>i.current?.view(),children:"Reset view"}),v("button",{onClick:async()=>{let _=await i.current?.picture();_&&Ua(_,`match-${n.id}.png`)},children:"Save picture"})]})]}),s!==null&&v("p",{class:"failure",children:s}),v("div",{class:"stage",children:[!l.overlay&&v(Ot,{children:[v("span",{class:"caption first",children:["Source",l.pose===1?", aligned":l.pose===0?", original pose":""]}),v("span",{class:"caption second",children:"Target"})]}),v("canvas",{ref:t,id:"view",tabIndex:0,role:"img","aria-label":"Source and target surface. Arrow keys turn, plus and minus zoom, Home resets the view.",onPointerMove:d,onPointerLeave:x,onKeyDown:y}),v("output",{class:"readout","aria-live":"off",children:o===null?v("span",{class:"hint",children:"Point at a vertex to see its correspondent. Drag to turn, scroll to zoom, right button to move."}):o.side==="source"?v(Ot,{children:[v("b",{children:["source vertex ",o.vertex]})," → ",o.others[0]<0?"no counterpart":`target vertex ${o.others[0]}`," · confidence ",Re(m.confidence[o.vertex],2)," · spread"," ",bi(m.spread[o.vertex])," · residual ",bi(m.residual[o.vertex])," · ",Qs[Math.floor(m.outlier[o.vertex]*Qs.length)]?.name]}):v(Ot,{children:[v("b",{children:["target vertex ",o.vertex]})," ← ",o.others.length===0?"no source vertex has it as its nearest":`${o.others.length} source ${o.others.length===1?"vertex":"vertices"}: ${o.others.slice(0,6).join(", ")}${o.others.length>6?" …":""}`,o.spread_mm>0&&` · spread ${bi(o.spread_mm)}`]})})]}),v("div",{class:"legend",children:[l.coloring==="outlier"?v("ul",{class:"categories",children:Qs.map(({name:_,color:S},b)=>{let M=m.outlier.reduce((w,g)=>w+(Math.floor(g*Qs.length)===b?1:0),0);return v("li",{children:[v("svg",{width:"12",height:"12","aria-hidden":"true",children:v("rect",{width:"12",height:"12",fill:Hv(S)})})," ",_,": ",M.toLocaleString("en")]})})}):v(XC,{map:l.map,low:l.coloring==="correspondence"?"one end of the target":l.coloring==="displacement"?`≤ −${Re(l.top,2)} mm`:`0 ${p.unit}`,high:l.coloring==="correspondence"?"the other end":`${l.coloring==="confidence"?"":"≥ "}${Re(l.top,2)} ${p.unit}`,label:`Scale of ${jt(l.coloring)}`}),v("p",{children:[p.help," Gray: no counterpart."]})]})]})}var qC=[["Correspondences, CSV","correspondences?format=csv","correspondences.csv"],["Aligned source, PLY","aligned?format=ply","aligned.ply"],["Bent source, PLY","warped?format=ply","warped.ply"],["Bent source, GIFTI","warped?format=gifti","warped.surf.gii"],["Bent source, VTP","warped?format=vtp","warped.vtp"],["Target surface, PLY","surfaces/target?format=ply","target.ply"],["Both surfaces in color, glTF","correspondences?format=glb","match.glb"],["Transform, ITK","transform?format=tfm","transform.tfm"],["Transform, FreeSurfer","transform?format=lta","transform.lta"],["Result, JSON","result","result.json"],["Report, HTML","report?format=html","report.html"]];function Zv({job:n,failed:e}){return v("div",{class:"saves",children:qC.map(([t,i,s])=>v("button",{onClick:()=>uc(`v1/jobs/${n.id}/${i}`,s).catch(e),children:t}))})}function Qv({id:n}){let[e,t]=pe(null),[i,s]=pe([]),[r,o]=pe(null),[a,l]=pe(null),[c,u]=pe(!0),[h,f]=pe(null),d=M=>f(Jt(M)),x=Ui();cn(M=>{t(null),s([]),o(null),l(null),f(null),Ni(()=>Mt(`v1/jobs/${n}`,M),M).then(L=>!M.aborted&&t(P=>P??L),L=>!M.aborted&&d(L));let w=[],g=0,T=()=>{g=0;let L=w;w=[],M.aborted||s(P=>[...P,...L])};Mg(n,{job:L=>t(P=>kr(P,{...L,queue_position:L.queue_position??(L.state==="queued"?P?.queue_position:void 0)})),trace:L=>{w.push(...L),g===0&&(g=window.setTimeout(T,60))},progress:L=>t(P=>P===null?P:{...P,progress:L}),connected:u,failed:d},M)},[n]);let y=e?.state==="succeeded";cn(M=>{!y||e===null||Xv(e,M).then(w=>{M.aborted||(l(w.result),o(w.pair))},w=>!M.aborted&&d(w))},[n,y]);let p=e!==null&&!oi(e.state),m=ii(()=>v(JC,{points:i,isLive:p}),[i,p]);if(e===null)return h===null?v("p",{class:"loading",children:"Loading the job …"}):v(Ht,{text:h});let _=ng(e),S=M=>{f(null),ri("POST",`v1/jobs/${n}/${M}`).then(w=>M==="retry"?fr(`jobs/${w.id}`):t(g=>g?.id===w.id?kr(g,w):g),d)},b=e.started_at?Di((e.finished_at?Date.parse(e.finished_at):x)-Date.parse(e.started_at)):null;return v("article",{class:"job",children:[v("h1",{class:"sub",children:["Job ",v("code",{children:n})]}),v("section",{class:`verdict ${_.tone}`,"aria-label":"Verdict",children:[v("span",{class:"mark","aria-hidden":"true",children:_.mark}),v("div",{children:[v("p",{class:"title",id:"verdict",children:_.title}),_.lines.map(M=>v("p",{children:M})),v("p",{class:"next",children:[v("b",{children:"Next:"})," ",_.next]})]}),v("div",{class:"actions",children:[!oi(e.state)&&v("button",{disabled:e.cancel_requested,onClick:()=>S("cancel"),children:"Cancel"}),oi(e.state)&&v("button",{onClick:()=>S("retry"),children:"Retry"})]})]}),v(Ht,{text:h}),!oi(e.state)&&v("p",{class:"live",role:"status",children:[v(Yi,{share:e.progress?.fraction??0,label:"Progress"})," ",Ao(e.progress?.fraction??0)," · ",e.progress?.message??jt(e.state)," ",b!==null&&`· ${b}`,!c&&v(Wn,{tone:"bad",children:"connection lost, trying again"})]}),r!==null&&v(jv,{job:e,pair:r}),y&&r===null&&h===null&&v("p",{class:"loading big",children:"Loading the surfaces …"}),v("div",{class:"columns",children:[a!==null&&v($C,{result:a}),m,v("section",{class:"card",children:[v("h2",{children:"The job"}),v(Xn,{rows:[["State",v(ko,{state:e.state})],["Method",`${e.method} ${e.method_version}`],["Source",`${Re(e.source.n_vertices)} vertices, ${e.source.report.format}`],["Target",`${Re(e.target.n_vertices)} vertices, ${e.target.report.format}`],["Priority",Re(e.priority)],["Attempt",`${e.attempt} of ${e.max_attempts}`],["Created",new Date(e.created_at).toLocaleString()],["Ran for",b??"–"],["Result from",e.cached?"an earlier, equal job":"this job"],...e.batch_id?[["Batch",v("a",{href:`#/batches/${e.batch_id}`,children:e.batch_id.slice(-8)})]]:[],...e.retry_of?[["Retry of",v("a",{href:`#/jobs/${e.retry_of}`,children:e.retry_of.slice(-8)})]]:[],...e.external_ref?[["Reference",e.external_ref]]:[],...Object.entries(e.labels).map(([M,w])=>[`Label ${M}`,w])]})]}),a!==null&&v(jC,{result:a}),y&&v("section",{class:"card",children:[v("h2",{children:"Save"}),v(Zv,{job:e,failed:d})]}),v(ZC,{job:e}),v("section",{class:"card",children:[v("h2",{children:"Parameters and provenance"}),v(KC,{job:e}),a!==null&&v(Xn,{rows:[["Program",`${a.provenance.version}, commit ${a.provenance.commit}`],["Seed",Re(a.provenance.seed)],["Source file",v("code",{class:"hash",children:e.source.hash})],["Target file",v("code",{class:"hash",children:e.target.hash})]]})]})]})]})}function $C({result:n}){let{surface_distance:e,topology:t,deformation:i,support:s,reliability:r}=n,o=[["Surface distance, mean",bi(e.mean_mm)],["Surface distance, 95 % within",bi(e.p95_mm)],["Surface distance, largest",bi(e.max_mm)],["Neighbors that stay neighbors",Ao(t.consistency)],["Target vertices reached",Ao(t.coverage)],["Inliers of the transform",`${Re(s.inliers)} (${Ao(s.ratio)})`],["Rotation",`${n.transform.rotation_angle_deg.toFixed(1)}°`]];return i&&o.push(["Folded triangles",`${Re(i.folded_triangles)} (${Ao(i.folded_area_share)} of the area)`],["Area, target over source (5th to 95th percentile)",`${Re(i.area_ratio)} (${Re(i.area_ratio_p05)} to ${Re(i.area_ratio_p95)})`],["Volume, target over source",Re(i.volume_ratio)]),r&&(o.push(["Misfit (about 1.0 for copies, 1.2 for two subjects)",Re(r.misfit)],["Misfit of the next best pose",Re(r.runner_up_misfit)],["Misfit of a mirrored source",Re(r.other_handedness_misfit)],["Curvature agreement",Re(r.curvature_agreement)],["Agreement of directions",Re(r.normal_agreement)]),r.distortion!==void 0&&o.push(["Distortion (0 if angles are kept, about 0.2 for two subjects)",Re(r.distortion)])),v("section",{class:"card",children:[v("h2",{children:"How good it is"}),v(Xn,{rows:o})]})}var Kv=4e3;function YC(n){if(n.length<=Kv)return n;let e=Math.ceil(2*n.length/Kv),t=[];for(let i=0;i<n.length;i+=e){let s=Math.min(n.length,i+e),[r,o]=[i,i];for(let a=i+1;a<s;a++){let l=n[a].energy;l!==void 0&&(l>=(n[r].energy??1/0)||(r=a),l<=(n[o].energy??-1/0)||(o=a))}for(let a=i;a<s;a++){let l=n[a];(a===r||a===o||a===n.length-1||l.support!==void 0||l.round!==n[a-1]?.round)&&t.push(l)}}return t}function JC({points:n,isLive:e}){let[t,i]=pe(!1),[s,r]=pe(!1),[o,a]=pe("all"),[l,c]=pe(null),u=ii(()=>n.filter(Fa),[n]),h=ii(()=>n.filter(w=>!Fa(w)&&(w.energy!==void 0||w.support!==void 0)),[n]),f=(l??(u.length>0?"field":"labels"))==="field"?u:h,d=ii(()=>[...new Set(f.map(w=>w.round))],[f]),x=d.map(String).includes(o),y=ii(()=>f.filter(w=>!x||String(w.round)===o),[f,x,o]),p=ii(()=>YC(y),[y]),m=w=>p.map(g=>{let T=g[w];return T===void 0||t&&w!=="support"&&T<=0?null:T}),_=w=>p.some(g=>g[w]!==void 0),S=p.flatMap((w,g)=>g===0||p[g-1].round!==w.round?[{at:w.seq,text:`round ${w.round}`}]:[]),b=y.at(-1),M=[{label:"energy",color:"#0072b2",values:m("energy"),width:2.5},...s?[{label:f===u?"misfit":"unary",color:"#d55e00",values:m("energy_unary"),dash:[6,3]},{label:f===u?"deformation":"pairwise",color:"#009e73",values:m("energy_pairwise"),dash:[2,3]}]:[],..._("lower_bound")?[{label:"lower bound",color:"#8c6d1f",values:m("lower_bound"),dash:[10,4]}]:[],..._("temperature")?[{label:"temperature",color:"#cc79a7",values:m("temperature"),scale:"right"}]:[],..._("support")&&!_("temperature")?[{label:"support (inliers)",color:"#b0607f",values:m("support"),scale:"right",points:!0}]:[]];return v("section",{class:"card wide",id:"trace","data-points":n.length,"data-last":n.at(-1)?.seq??0,children:[v("h2",{children:["Energy ",e&&v(Wn,{tone:"wait",children:"live"})]}),v("div",{class:"tools",children:[v(Ns,{label:"Logarithmic",checked:t,onChange:w=>i(w.currentTarget.checked)}),v(Ns,{label:"Its parts",checked:s,onChange:w=>r(w.currentTarget.checked)}),u.length>0&&h.length>0&&v("label",{children:["Of"," ",v("select",{value:f===u?"field":"labels",onChange:w=>c(w.currentTarget.value==="field"?"field":"labels"),children:[v("option",{value:"field",children:"the displacement field"}),v("option",{value:"labels",children:"the labels"})]})]}),d.length>1&&v("label",{children:["Round"," ",v("select",{value:x?o:"all",onChange:w=>a(w.currentTarget.value),children:[v("option",{value:"all",children:"all"}),d.map(w=>v("option",{value:String(w),children:w}))]})]}),b&&v("span",{children:[n.length," points · latest ",Re(b.energy??null)," in ",jt(b.phase),", round ",b.round,", iteration ",b.iteration]})]}),p.length===0?v("p",{class:"hint",children:e?"The first point comes with the first iteration.":"This method minimizes no energy, or its trace has been removed."}):v(zo,{title:`Energy over ${n.length} points, the last one ${Re(b?.energy??null)}`,x:p.map(w=>w.seq),series:M,log:t,height:260,xLabel:"point of the trace",yLabel:"energy, lower is better",rightLabel:_("temperature")?"temperature":"inliers",marks:S})]})}function jC({result:n}){let{total:e=1,...t}=n.timings_ms,i=Object.entries(t).sort(([,s],[,r])=>r-s);return v("section",{class:"card",children:[v("h2",{children:["Time: ",Di(e)]}),v(Xn,{rows:i.map(([s,r])=>[jt(s),v(Ot,{children:[v(Yi,{share:r/e,label:`Share of ${jt(s)}`})," ",Di(r)]})])})]})}function ZC({job:n}){let{source:e,target:t}=n,i=(s,r)=>v("tr",{children:[v("th",{scope:"row",children:s}),v("td",{children:r(e)}),v("td",{children:r(t)})]});return v("section",{class:"card",children:[v("h2",{children:"Surfaces"}),v("table",{class:"plain",children:[v("thead",{children:v("tr",{children:[v("td",{}),v("th",{scope:"col",children:"Source"}),v("th",{scope:"col",children:"Target"})]})}),v("tbody",{children:[i("Format",s=>s.report.format),i("Vertices",s=>Re(s.n_vertices)),i("Faces",s=>Re(s.n_faces)),i("Genus",s=>String(s.report.topology.genus??"open")),i("Pieces",s=>Re(s.report.topology.n_components)),i("Boundary edges",s=>Re(s.report.topology.n_boundary_edges)),i("Area",s=>`${Re(s.report.topology.area_mm2)} mm²`),i("Volume",s=>s.report.topology.volume_mm3===null?"–":`${Re(s.report.topology.volume_mm3)} mm³`),i("Repairs",s=>s.report.repairs.length===0?"none":String(s.report.repairs.length))]})]})]})}function KC({job:n}){let[e,t]=pe(null);cn(o=>{Ni(()=>Mt(`v1/methods/${n.method}`,o),o).then(a=>!o.aborted&&t(a.defaults),()=>{})},[n.method]);let i=em(n.parameters),s=new Map(e?em(e):[]),r=e===null?[]:i.filter(([o,a])=>o!=="seed"&&s.get(o)!==a);return v(Ot,{children:[v("p",{children:e===null?"":r.length===0?`All as the method ${n.method} sets them.`:`Different from the method ${n.method}:`}),r.length>0&&v(Xn,{rows:r.map(([o,a])=>[o,v("code",{children:a})])}),v("details",{children:[v("summary",{children:["All ",i.length," parameters"]}),v(Xn,{rows:i.map(([o,a])=>[o,v("code",{children:a})])})]})]})}function em(n,e=""){return n===null||typeof n!="object"||Array.isArray(n)?[[e,JSON.stringify(n)]]:Object.entries(n).flatMap(([t,i])=>em(i,e===""?t:`${e}.${t}`))}function QC(n){let e=new Map;for(let t of n.split(`
`)){let i=/^([a-zA-Z_:][\w:]*)(?:\{(.*)\})? (\S+)$/.exec(t);if(!i||t.startsWith("#"))continue;let s=Object.fromEntries([...(i[2]??"").matchAll(/(\w+)="((?:[^"\\]|\\.)*)"/g)].map(([,o,a])=>[o,a])),r=e.get(i[1])??[];r.push({labels:s,value:Number(i[3])}),e.set(i[1],r)}return e}var ey=500;function ty(){let[n,e]=pe(null),[t,i]=pe([]),[s,r]=pe([]),[o,a]=pe([]),[l,c]=pe(null),[u,h]=pe(null),f=Ui();if(cn(g=>{(async()=>{for(let T=0;!g.aborted;T++){try{let L=QC(await(await si("metrics",{signal:g})).text()),P=D=>L.get("homolog_jobs")?.find(({labels:I})=>I.state===D)?.value??0;e(L),i(D=>[...D.slice(-299),{at:Date.now(),queued:P("queued"),running:P("running")}]),r((await Mt("v1/jobs?state=running&page_size=100",g)).jobs),Mt("readyz",g).then(({dependencies:D})=>c(D),D=>c(D instanceof hi?D.problem.dependencies??{}:null)),T%10===0&&a(await eR(g)),h(null)}catch(L){g.aborted||h(Jt(L))}await Hn(2e3,g)}})()},[]),n===null)return u===null?v("p",{class:"loading",children:"Loading …"}):v(Ht,{text:u});let d=g=>n.get(g)?.[0]?.value??0,x=(g,T)=>(n.get(g)??[]).map(({labels:L,value:P})=>[L[T]??Object.values(L).join(" "),P]).filter(([,L])=>L>0),y=t.at(-1),p=d("homolog_queue_oldest_age_seconds"),m=d("homolog_job_store_up")===1,_=Object.entries(l??{}).filter(([,g])=>g!=="ok"),S=y.queued>0&&y.running===0&&p>30,b=!m||_.length>0||S?"bad":p>600?"wait":"good",M=new Map;for(let g of s){let T=g.worker??"unnamed worker";M.set(T,[...M.get(T)??[],g])}let w=t[0].at;return v("div",{children:[v("h1",{children:"Operations"}),v("section",{class:`verdict ${b}`,"aria-label":"Verdict",children:[v("span",{class:"mark","aria-hidden":"true",children:b==="good"?"✓":b==="bad"?"✕":"…"}),v("div",{children:[v("p",{class:"title",children:b==="good"?"The queue is well":S?"Nothing runs":b==="wait"?"Jobs wait long":"A dependency fails"}),v("p",{children:[Re(y.queued)," queued, ",Re(y.running)," running; the oldest has waited ",Di(p*1e3),"."]}),v("p",{class:"next",children:[v("b",{children:"Next:"})," ",b==="good"?"nothing to do.":S?"Look whether workers run, and whether a job asks for more memory than there is.":b==="wait"?"Add workers, or lower the priority of what can wait.":`Look at ${_.map(([g,T])=>`${g} (${T})`).join(", ")||"the database"}.`]})]})]}),v(Ht,{text:u}),v("div",{class:"columns",children:[v("section",{class:"card wide",children:[v("h2",{children:"Queue, since this page was opened"}),v(zo,{title:`Queued ${y.queued}, running ${y.running}`,x:t.map(({at:g})=>(g-w)/1e3),series:[{label:"queued",color:"#2f7ebc",values:t.map(({queued:g})=>g),width:2},{label:"running",color:"#d55e00",values:t.map(({running:g})=>g),width:2}],height:220,xLabel:"seconds",yLabel:"jobs"})]}),v("section",{class:"card",children:[v("h2",{children:"Workers and what they run"}),M.size===0&&v("p",{class:"hint",children:"No job is running."}),[...M].map(([g,T])=>v("div",{children:[v("h3",{children:[v("code",{children:g}),": ",T.length," ",T.length===1?"job":"jobs"]}),v("ul",{class:"running",children:T.map(L=>v("li",{children:[v("a",{href:`#/jobs/${L.id}`,children:["…",ai(L.id)]})," ",L.method,", ",jt(L.progress?.phase??"starting"),", ",L.started_at?ds(L.started_at,f):""," ",v(Yi,{share:L.progress?.fraction??0,label:`Progress of ${ai(L.id)}`})]}))})]},g))]}),v("section",{class:"card",children:[v("h2",{children:"Failures by kind"}),o.length===0?v("p",{class:"hint",children:"No job of this tenant has failed."}):v(Xn,{rows:o.map(([g,T,L])=>[g,v(Ot,{children:[Re(T),", newest ",v("a",{href:`#/jobs/${L}`,children:["…",ai(L)]})]})])}),v("p",{class:"soft",children:["Among the last ",ey," jobs of this tenant that failed or were given up."]})]}),v("section",{class:"card",children:[v("h2",{children:"Finished since the service was started"}),v(Xn,{rows:x("homolog_jobs_finished_total","state").map(([g,T])=>[g,Re(T)])}),v(Xn,{rows:x("homolog_problems_total","type").map(([g,T])=>[`Refused: ${jt(g).replaceAll("-"," ")}`,Re(T)])})]}),v("section",{class:"card",children:[v("h2",{children:"This process"}),v(Xn,{rows:[...Object.entries(l??{}).map(([g,T])=>[jt(g),v(Wn,{tone:T==="ok"?"good":"bad",children:T})]),["Memory",hc(d("process_resident_memory_bytes"))],["Running since",d("process_start_time_seconds")?new Date(1e3*d("process_start_time_seconds")).toLocaleString():"–"],["Leases of lost workers",Re(d("homolog_leases_expired_total"))],["Jobs given up",Re(d("homolog_jobs_dead_total"))]]})]})]})]})}async function eR(n){let e=await Promise.all(["failed","dead"].map(i=>Mt(`v1/jobs${yi({state:i,page_size:ey})}`,n))),t=new Map;for(let i of e.flatMap(({jobs:s})=>s)){let s=i.error?.title??"Crashed too often",[r,o]=t.get(s)??[0,i.id];t.set(s,[r+1,o>i.id?o:i.id])}return[...t].map(([i,[s,r]])=>[i,s,r]).sort(([,i],[,s])=>s-i)}var tR={queued:"wait",matching:"wait",modelling:"wait",finished:"good",failed:"bad",cancelled:"neutral"},tm=({state:n})=>v(Wn,{tone:tR[n],children:n==="modelling"?"modeling":n}),Qh=n=>n==="finished"||n==="failed"||n==="cancelled";function nm({state:n,progress:e}){let{template_round:t,matches_done:i,matches_total:s}=e;return n==="queued"?"waits for a worker":n==="modelling"?"computes the shape model and the statistics":n==="matching"?`${t>0?`makes the template, round ${t}`:"matches the subjects"}: ${Re(i)} of ${Re(s)}`:n}function ny(){let[n,e]=pe([]),[t,i]=pe(),[s,r]=pe(null),[o,a]=pe(!1),l=Ui(),c=async(u,h)=>{try{let f=await Mt(`v1/studies${yi({page_size:50,page_token:u})}`,h);e(d=>u===void 0?f.studies:[...d,...f.studies]),i(f.next_page_token),r(null),a(!0)}catch(f){h?.aborted||r(Jt(f))}};return cn(u=>{(async()=>{for(await c(void 0,u);!u.aborted;)await Hn(3e3,u),!u.aborted&&!document.hidden&&scrollY<200&&await c(void 0,u)})()},[]),v("div",{children:[v("h1",{children:"Studies"}),v(Ht,{text:s}),o&&n.length===0&&v("p",{class:"empty",children:["There is no study yet. ",v("code",{children:"POST /v1/studies"})," or ",v("code",{children:"homolog study"})," begins one; ",v("a",{href:"docs/",children:"the API"})," says how."]}),n.length>0&&v("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Studies",children:v("table",{children:[v("thead",{children:v("tr",{children:[v("th",{scope:"col",children:"Study"}),v("th",{scope:"col",children:"State"}),v("th",{scope:"col",children:"Progress"}),v("th",{scope:"col",class:"numeric",children:"Subjects"}),v("th",{scope:"col",children:"Method"}),v("th",{scope:"col",children:"Labels"}),v("th",{scope:"col",children:"Age"})]})}),v("tbody",{children:n.map(u=>v("tr",{children:[v("td",{children:v("a",{href:`#/studies/${u.id}`,children:u.external_ref??`…${ai(u.id)}`})}),v("td",{children:v(tm,{state:u.state})}),v("td",{children:[u.state==="matching"&&v(Yi,{share:u.progress.matches_done/Math.max(1,u.progress.matches_total),label:`Progress of ${u.external_ref??ai(u.id)}`}),!Qh(u.state)&&v("span",{class:"soft",children:nm(u)}),u.error&&v("span",{class:"soft",children:u.error.title})]}),v("td",{class:"numeric",children:Re(u.n_subjects)}),v("td",{children:u.method}),v("td",{children:Object.entries(u.labels).map(([h,f])=>`${h}:${f}`).join(", ")}),v("td",{children:ds(u.created_at,l)})]},u.id))})]})}),t!==void 0&&v("button",{onClick:()=>{c(t)},children:"More"})]})}function iy(n){let e=[[]],[t,i]=["",!1],s=()=>{e.at(-1).push(/^'[=+\-@\t\r\n]/.test(t)?t.slice(1):t),t=""};for(let a=0;a<n.length;a++){let l=n[a];i?l!=='"'?t+=l:n[a+1]==='"'?t+=n[++a]:i=!1:l==='"'?i=!0:l===","?s():l===`
`?(s(),e.push([])):l!=="\r"&&(t+=l)}(t!==""||e.at(-1).length>0)&&s();let[r=[],...o]=e;return o.filter(a=>a.length>0).map(a=>Object.fromEntries(r.map((l,c)=>[l,a[c]??""])))}function im({map:n,title:e,ticks:t}){let i=tn(null);return xt(()=>{i.current?.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(er(n)),Zn,1),0,0)},[n]),v("figure",{class:"colorbar",children:[v("figcaption",{children:e}),v("canvas",{ref:i,width:Zn,height:1,role:"img","aria-label":`Color bar of ${e}, from ${t[0]} to ${t.at(-1)}`}),v("div",{class:"ticks","aria-hidden":"true",children:t.map(s=>v("span",{children:s},s))})]})}function sy(n){let e=new $s(er(n),Zn,1);return e.needsUpdate=!0,e}function sm(n){let e=n.getAttribute("position").count;n.hasAttribute("value")||n.setAttribute("value",new Ft(new Float32Array(e).fill(-1e9),1));let t=Zh(sy("viridis"));return t.uniforms.byPlace.value=!1,t.uniforms.grid.value=!1,new Mn(n,t)}function rm(n,{values:e,low:t,high:i,map:s}){let{uniforms:r}=n.material;r.map.value.dispose(),r.map.value=sy(s),r.low.value=t,r.top.value=Math.max(i,t+1e-12);let o=n.geometry.getAttribute("value");for(let a=0;a<o.count;a++)o.array[a]=Number.isFinite(e[a])?e[a]:-1e9;o.needsUpdate=!0}function om(n,e,t){n.up.copy(e.axes[1]),n.position.copy(e.center).addScaledVector(e.axes[2],4*t),[n.near,n.far,n.zoom]=[-20*t,40*t,1],n.lookAt(e.center)}function am(n,e,t,i){let{low:s,high:r}=e,o=Math.max(2.2*Math.max(-s.x,r.x)/t,2.3*Math.max(-s.y,r.y,-s.z,r.z)/i);[n.left,n.right,n.top,n.bottom]=[-t,t,i,-i].map(a=>a*o/2),n.updateProjectionMatrix()}var ef=class{constructor(e,t){this.canvas=e;this.renderer=new Ss({canvas:e,antialias:!0,alpha:!1}),this.renderer.setPixelRatio(Math.min(2,window.devicePixelRatio)),this.mesh=sm(t),this.mesh.frustumCulled=!1,this.scene.add(this.mesh),this.frame=Ts(t),this.radius=t.boundingSphere?.radius||1,this.controls=new Pr(this.camera,e),this.controls.staticMoving=!0,this.controls.rotateSpeed=3,this.controls.addEventListener("change",()=>this.redraw()),this.view(),this.sizes.observe(e);let i=()=>{this.waiting=requestAnimationFrame(i),this.controls.update(),this.isDirty&&this.draw()};i()}canvas;renderer;camera=new Pi;controls;scene=new es;mesh;frame;radius;sizes=new ResizeObserver(()=>this.resize());waiting=0;isDirty=!0;dispose(){cancelAnimationFrame(this.waiting),this.sizes.disconnect(),this.controls.dispose(),this.mesh.material.dispose(),this.mesh.geometry.dispose(),this.renderer.dispose()}color(e){rm(this.mesh,e),this.redraw()}move(e){let t=this.mesh.geometry.getAttribute("position");t.array.set(e),t.needsUpdate=!0,this.mesh.geometry.computeVertexNormals(),this.mesh.geometry.computeBoundingSphere(),this.redraw()}view(){this.controls.target.copy(this.frame.center),om(this.camera,this.frame,this.radius),this.resize()}turn(e,t){let i=this.camera.position.clone().sub(this.controls.target),s=new W().crossVectors(this.camera.up,i).normalize(),r=new Sn().setFromAxisAngle(this.camera.up.clone().normalize(),e);r.premultiply(new Sn().setFromAxisAngle(s,t)),this.camera.up.applyQuaternion(r).normalize(),this.camera.position.copy(this.controls.target).add(i.applyQuaternion(r)),this.camera.lookAt(this.controls.target),this.redraw()}zoom(e){this.camera.zoom=Math.min(40,Math.max(.2,this.camera.zoom*e)),this.camera.updateProjectionMatrix(),this.redraw()}redraw(){this.isDirty=!0}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e===0||t===0||(this.renderer.setSize(e,t,!1),am(this.camera,this.frame,e,t),this.controls.handleResize(),this.redraw())}draw(){this.isDirty=!1,this.renderer.setClearColor(new it(getComputedStyle(this.canvas).getPropertyValue("--canvas").trim()||"#f4f6f8")),this.renderer.render(this.scene,this.camera)}pick(e,t){let i=new eo,{clientWidth:s,clientHeight:r}=this.canvas;this.camera.updateMatrixWorld(),i.setFromCamera(new Ze(2*e/s-1,1-2*t/r),this.camera);let o=i.intersectObject(this.mesh)[0];if(!o?.face)return null;let a=this.mesh.geometry.getAttribute("position"),l=c=>o.point.distanceToSquared(new W().fromBufferAttribute(a,c));return[o.face.a,o.face.b,o.face.c].reduce((c,u)=>l(u)<l(c)?u:c)}project(e){this.camera.updateMatrixWorld();let{geometry:t}=this.mesh,i=new W().fromBufferAttribute(t.getAttribute("position"),e).project(this.camera),s=new W().fromBufferAttribute(t.getAttribute("normal"),e),r=new W().setFromMatrixColumn(this.camera.matrixWorld,2);return{x:(i.x+1)/2*this.canvas.clientWidth,y:(1-i.y)/2*this.canvas.clientHeight,facing:s.dot(r)}}picture(){return this.draw(),new Promise(e=>this.canvas.toBlob(e,"image/png"))}};function ho(n){let e=new DataView(n),t=0,i=()=>{let l="";for(;t<e.byteLength;){let c=e.getUint8(t++);if(c===10)break;l+=String.fromCharCode(c)}return l},s=()=>{for(;;){let l=i().trim();if(l!==""||t>=e.byteLength)return l.split(" ")}},r=(l,c)=>{let u={double:8,vtktypeint64:8,float:4,int:4,unsigned_char:1}[c??""];if(u===void 0||t+l*u>e.byteLength)throw new Error("This VTK file cannot be read.");let h=d=>{let x=t+d*u;return c==="double"?e.getFloat64(x):c==="float"?e.getFloat32(x):c==="vtktypeint64"?Number(e.getBigInt64(x)):c==="int"?e.getInt32(x):e.getUint8(x)},f=Float64Array.from({length:l},(d,x)=>h(x));return t+=l*u,f},o=new Jn,a={};for(let l=0;l<4;l++)i();for(;t<e.byteLength;){let[l,c,u]=s();if(l==="POINTS")o.setAttribute("position",new Ft(Float32Array.from(r(3*Number(c),u)),3));else if(l==="POLYGONS"){let h=r(Number(c),s()[1]),f=r(Number(u),s()[1]),d=[];for(let x=0;x+1<h.length;x++)for(let y=h[x]+1;y+1<h[x+1];y++)d.push(f[h[x]],f[y],f[y+1]);o.setIndex(new Ft(Uint32Array.from(d),1))}else if(l==="FIELD")for(let h=0;h<Number(u);h++){let[f,d,x,y]=s();a[f]=Float32Array.from(r(Number(d)*Number(x),y))}}return o.computeVertexNormals(),o.computeBoundingSphere(),{geometry:o,arrays:a}}function ay({geometry:n,coloring:e,positions:t,label:i,id:s,file:r,readout:o}){let a=tn(null),l=tn(null),[c,u]=pe(null),[h,f]=pe(null),d=qr();xt(()=>{try{l.current=new ef(a.current,n.clone())}catch{u("This browser cannot draw in 3D (WebGL 2 is not available). The maps are in the archive.");return}return a.current.scene=l.current,()=>{l.current?.dispose(),l.current=null}},[n]),xt(()=>{e&&l.current?.color(e)},[n,e]),xt(()=>{t&&l.current?.move(t)},[n,t]),xt(()=>l.current?.redraw(),[d]);let x=p=>{if(p.buttons!==0)return;let m=a.current.getBoundingClientRect();f(l.current?.pick(p.clientX-m.left,p.clientY-m.top)??null)},y=p=>{let _={ArrowLeft:[-.12,0],ArrowRight:[.12,0],ArrowUp:[0,-.12],ArrowDown:[0,.12]}[p.key];if(_)l.current?.turn(..._);else if(p.key==="+"||p.key==="=")l.current?.zoom(1.2);else if(p.key==="-")l.current?.zoom(1/1.2);else if(p.key==="Home")l.current?.view();else return;p.preventDefault()};return v(Ot,{children:[v(Ht,{text:c}),v("div",{class:"stage half",children:v("canvas",{ref:a,id:s,tabIndex:0,role:"img","aria-label":`${i}. Arrow keys turn, plus and minus zoom, Home resets the view.`,onPointerMove:x,onPointerLeave:()=>f(null),onKeyDown:y})}),v("output",{class:"readout","aria-live":"off",children:h===null?v("span",{class:"hint",children:"Point at a vertex for its values. Drag to turn, scroll to zoom."}):o(h)}),v("div",{class:"tools",children:[v("button",{onClick:()=>l.current?.view(),children:"Reset view"}),v("button",{onClick:async()=>{let p=await l.current?.picture();p&&Ua(p,r)},children:"Save picture"})]})]})}var ry={normal_displacement:{title:"normal displacement",unit:"mm"},log_area:{title:"logarithm of area",unit:"ln"},thickness:{title:"thickness",unit:"mm"}},nR=[{name:"effect",title:"effect",kind:"effect"},{name:"hedges_g",title:"Hedges' g",kind:"signed"},{name:"t",title:"t",kind:"signed"},{name:"z",title:"z",kind:"signed"},{name:"p_tfce_fwe",title:"p, corrected (TFCE, family-wise)",kind:"p"},{name:"p_permutation",title:"p, uncorrected (permutations)",kind:"p"},{name:"p",title:"p, uncorrected",kind:"p"},{name:"q_fdr",title:"q (false discovery rate)",kind:"p"}],oy=3,ly=n=>[-1,-.5,0,.5,1].map(e=>e===0?"0":`${e===-1?"≤ ":e===1?"≥ ":""}${e<0?"−":""}${Re(Math.abs(e)*n,2)}`),cy=n=>Wh(n.map(Math.abs),.99)||1e-6;function uy({archive:n,result:e,name:t}){let i=e.found.maps.filter(({measure:I,contrast:U})=>n.has(`maps/${I}.${U}.vtk`)),s=[...new Set(i.map(({contrast:I})=>I))],[r,o]=pe(s[0]??""),[a,l]=pe(i[0]?.measure??""),[c,u]=pe("effect"),[h,f]=pe(!1),[d,x]=pe(null),[y,p]=pe(null),m=`maps/${a}.${r}.vtk`;cn(I=>{n.has(m)&&n.bytes(m).then(U=>{if(I.aborted)return;let{geometry:N,arrays:G}=ho(U);x(Y=>({file:m,geometry:Y?.geometry??N,arrays:G}))},U=>!I.aborted&&p(Jt(U)))},[n,m]);let _=d?.arrays,S=nR.filter(({name:I})=>_===void 0||I in _),b=S.find(({name:I})=>I===c)??S[0],M=_?.p_tfce_fwe??_?.q_fdr,{title:w,unit:g}=ry[a]??{title:jt(a),unit:""},T=ii(()=>{let I=_?.[b.name];if(I===void 0)return null;let U=G=>!h||M===void 0||M[G]<.05;if(b.kind==="p")return{coloring:{values:I.map((Y,k)=>U(k)?-Math.log10(Math.max(Y,10**-oy)):NaN),low:0,high:oy,map:"viridis"},ticks:["1","0.1","0.01","≤ 0.001"],map:"viridis"};let N=cy(I);return{coloring:{values:I.map((G,Y)=>U(Y)?G:NaN),low:-N,high:N,map:"blue_red"},ticks:ly(N),map:"blue_red"}},[_,b.name,h]);if(i.length===0)return v("p",{class:"hint",children:"No effect was asked for, so there are no maps."});let L=i.find(I=>I.measure===a&&I.contrast===r),P=b.kind==="effect"?`effect on ${w}${g==="mm"?", mm":g==="ln"?", natural logarithm":""}`:`${b.title} of ${w}`,D=_&&M?M.filter(I=>I<.05).length:null;return v(Ot,{children:[v("div",{class:"tools",children:[v("label",{children:["Contrast"," ",v("select",{value:r,onChange:I=>o(I.currentTarget.value),children:s.map(I=>v("option",{value:I,children:I}))})]}),v("label",{children:["Measure"," ",v("select",{value:a,onChange:I=>l(I.currentTarget.value),children:i.filter(I=>I.contrast===r).map(I=>v("option",{value:I.measure,children:ry[I.measure]?.title??jt(I.measure)}))})]}),v("label",{children:["Color by"," ",v("select",{value:b.name,onChange:I=>u(I.currentTarget.value),children:S.map(({name:I,title:U})=>v("option",{value:I,children:U}))})]}),v(Ns,{label:"Only corrected p < 0.05",checked:h,onChange:I=>f(I.currentTarget.checked)})]}),v(Ht,{text:y}),d===null?v("p",{class:"loading big",children:"Loading the map …"}):v(ay,{geometry:d.geometry,coloring:T?.coloring??null,id:"map",label:`The mean surface, colored by ${P}, contrast ${r}`,file:`${t}-${a}-${r}-${b.name}.png`,readout:I=>`vertex ${I} · ${S.map(({name:U,title:N,kind:G})=>`${N.split(" (")[0]} ${Re(_?.[U]?.[I])}${G==="effect"&&g==="mm"?" mm":""}`).join(" · ")}`}),v("div",{class:"legend",children:[T&&v(im,{map:T.map,title:P,ticks:T.ticks}),v("p",{id:"map-says",children:[L&&`Smallest corrected p ${Re(L.smallest_p,2)}; ${Re(100*L.significant_share,2)} % of the surface below 0.05${D===null?"":` (${Re(D)} vertices)`}.`,b.kind!=="p"&&" Red: above zero; blue: below."," ",h&&"Gray: not below 0.05."]})]})]})}var fo=2;function hy({archive:n,result:e,name:t}){let{compactness:i}=e.found.model,s=y=>100*(i[y-1]-(i[y-2]??0)),r=i.map((y,p)=>p+1).filter(y=>n.has(`modes/mode-${y}-plus-2sd.vtk`)),[o,a]=pe(r[0]??1),[l,c]=pe(fo),[u,h]=pe(null),[f,d]=pe(null);cn(y=>{r.length!==0&&Promise.all(["minus","plus"].map(p=>n.bytes(`modes/mode-${o}-${p}-2sd.vtk`))).then(([p,m])=>{if(y.aborted)return;let[_,S]=[ho(p).geometry,ho(m).geometry],[b,M]=[_,S].map(T=>T.getAttribute("position").array),w=b.map((T,L)=>(T+M[L])/2),g=b.map((T,L)=>(M[L]-T)/(2*fo));h(T=>T?{...T,step:g}:(_.getAttribute("position").array.set(w),_.computeVertexNormals(),_.computeBoundingSphere(),{geometry:_,mean:w,normals:Float32Array.from(_.getAttribute("normal").array),step:g}))},p=>!y.aborted&&d(Jt(p)))},[n,o]);let x=ii(()=>{if(u===null)return null;let{mean:y,normals:p,step:m}=u,_=Float32Array.from({length:y.length/3},(M,w)=>new W().fromArray(m,3*w).dot(new W().fromArray(p,3*w))),S=fo*cy(_);return{coloring:{values:_.map(M=>l*M),low:-S,high:S,map:"blue_red"},top:S,positions:y.map((M,w)=>M+l*m[w])}},[u,l]);return r.length===0?v("p",{class:"hint",children:"The model has no modes."}):v(Ot,{children:[v("div",{class:"tools",children:[v("label",{children:["Mode"," ",v("select",{value:String(o),onChange:y=>a(Number(y.currentTarget.value)),children:r.map(y=>v("option",{value:String(y),children:[y,": ",Re(s(y))," % of the variance"]}))})]}),v("label",{class:"slider",children:["−",fo," SD"," ",v("input",{type:"range",min:-fo,max:fo,step:.1,value:l,"aria-label":"Standard deviations along the mode","aria-valuetext":`${l.toFixed(1)} standard deviations`,onInput:y=>c(Number(y.currentTarget.value))})," +",fo," SD"]}),v("button",{onClick:()=>c(0),children:"Mean"})]}),v(Ht,{text:f}),u===null?v("p",{class:"loading big",children:"Loading the mode …"}):v(ay,{geometry:u.geometry,coloring:x.coloring,positions:x.positions,id:"mode",label:`The mean shape, moved by ${l.toFixed(1)} standard deviations along mode ${o}`,file:`${t}-mode-${o}-${l.toFixed(1)}sd.png`,readout:y=>`vertex ${y} · ${Re(x.coloring.values[y])} mm along the normal of the mean`}),v("div",{class:"legend",children:[x&&v(im,{map:"blue_red",title:"displacement along the normal of the mean, mm",ticks:ly(x.top)}),v("p",{children:["The mean ",l===0?"itself":`and ${l>0?"+":"−"}${Math.abs(l).toFixed(1)} standard deviations`," along mode ",o,", which explains ",Re(s(o))," % of the variance. Red: outwards; blue: inwards."]})]})]})}var[lm,cm]=[88,40],iR=500,sR=250,tr,Ta=new Map,fy=Promise.resolve();function rR({geometry:n,coloring:e,frame:t=Ts(n)}){if(tr===void 0)try{tr=new Ss({antialias:!0,alpha:!0,preserveDrawingBuffer:!0}),tr.setPixelRatio(2),tr.setSize(lm,cm,!1)}catch{tr=null}if(tr===null)return null;let[i,s,r]=[sm(n),new es,new Pi];return e&&rm(i,e),s.add(i),om(r,t,n.boundingSphere?.radius||1),am(r,t,lm,cm),tr.setClearColor(0,0),tr.render(s,r),i.material.uniforms.map.value.dispose(),i.material.dispose(),n.dispose(),tr.domElement.toDataURL()}function dy({name:n,alt:e,load:t}){let i=tn(null),[s,r]=pe(!1),[o,a]=pe(Ta.get(n)??null);return xt(()=>{let l=0,c=new IntersectionObserver(u=>{clearTimeout(l),u.at(-1).isIntersecting&&(l=window.setTimeout(()=>r(!0),sR))});return c.observe(i.current),()=>{clearTimeout(l),c.disconnect()}},[]),cn(l=>{a(Ta.get(n)??null),!(!s||Ta.has(n))&&(fy=fy.then(async()=>{if(l.aborted)return;let c=await t(l).catch(()=>null),u=c===null||l.aborted?null:rR(c);u!==null&&(Ta.size>=iR&&Ta.clear(),Ta.set(n,u),a(u))}))},[n,s]),v("span",{class:"picture",ref:i,children:o!==null&&v("img",{src:o,width:lm,height:cm,alt:e})})}var oR={model:{text:"in the model",tone:"good"},scored:{text:"compared with the model",tone:"good"},unreliable:{text:"left out: match not reliable",tone:"bad"},dropped:{text:"excluded by decision",tone:"neutral"},failed:{text:"no match",tone:"bad"}};function aR({flags:n="",reasons:e="",error:t=""}){let i=n.split("; ").filter(Boolean),s=[jt(e).replaceAll(";",","),t].filter(Boolean).join(", ");return i.map((r,o)=>o===0&&s!==""?`${r} (${s})`:r).join(", ")||s}var um=100;function py({study:n,rows:e,matches:t,deciding:i,picture:s,version:r,top:o}){let[a,l]=pe(null),[c,u]=pe(um),[h,f]=pe(!1),d=new Map((n.subjects??[]).map(p=>[p.id,p])),x=e??(n.subjects??[]).map(({id:p})=>({id:p})),y=x.filter(p=>!h||p.flags||d.get(p.id)?.decision);return x.length===0?null:v("section",{"aria-label":"Quality control",class:"section",children:[v("h2",{children:"Quality control"}),v("div",{class:"tools",children:[v("span",{class:"hint",children:e===null?"The subjects and their matches.":`The most urgent first. Pictures: the template bent onto the subject; red lies outside of the mean (${Re(o,2)} mm or more), blue inside.`}),e!==null&&v("label",{class:"check",children:[v("input",{type:"checkbox",checked:h,onChange:p=>f(p.currentTarget.checked)})," Only those to look at, or decided"]})]}),v("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Subjects",children:v("table",{class:"quality",children:[v("thead",{children:v("tr",{children:[v("th",{scope:"col",children:"Subject"}),e!==null&&v(Ot,{children:[v("th",{scope:"col",children:"Shape"}),v("th",{scope:"col",children:"Place"}),v("th",{scope:"col",children:"Look at"}),v("th",{scope:"col",class:"numeric",children:"Residual, mm"}),v("th",{scope:"col",class:"numeric",children:"Turned over, %"}),v("th",{scope:"col",class:"numeric",children:"Unusual, p"})]}),v("th",{scope:"col",children:"Match"}),v("th",{scope:"col",children:"Decision"})]})}),v("tbody",{children:y.slice(0,c).map(p=>{let m=p.id,_=t.get(m),S=oR[p.place??""],b=d.get(m),M=p.place!=="failed";return v("tr",{"data-subject":m,"data-place":p.place,children:[v("th",{scope:"row",children:m}),e!==null&&v(Ot,{children:[v("td",{children:s&&M&&v(dy,{name:`${r}/${m}`,alt:`Shape of ${m}`,load:()=>s(m)})}),v("td",{children:S&&v(Wn,{tone:S.tone,children:S.text})}),v("td",{class:"why",children:aR(p)}),v("td",{class:"numeric",children:M?Number(p.residual_mm).toFixed(3):""}),v("td",{class:"numeric",children:M?(100*Number(p.folded)).toFixed(2):""}),v("td",{class:"numeric",children:p.mahalanobis_p?Re(Number(p.mahalanobis_p),2):""})]}),v("td",{children:_&&v("a",{href:`#/jobs/${_.id}`,children:_.state})}),v("td",{class:"decision",children:a===m?v(lR,{subject:m,cancel:()=>l(null),decide:async(w,g)=>{await i.decide(m,w,g),l(null)}}):b?.decision?v(Ot,{children:[v(Wn,{tone:b.decision==="kept"?"good":"neutral",children:b.decision==="kept"?"keep":"exclude"})," ",b.reason," ",v("button",{"aria-label":`Take back the decision about ${m}`,onClick:()=>{i.undo(m).catch(()=>{})},children:"Take back"})]}):v("button",{"aria-label":`Decide about ${m}`,onClick:()=>l(m),children:"Decide …"})})]},m)})})]})}),y.length===0&&v("p",{class:"empty",children:"Nobody is to be looked at."}),y.length>c&&v("button",{onClick:()=>u(c+um),children:["Further ",Re(Math.min(um,y.length-c))," of ",Re(y.length)]})]})}function lR({subject:n,decide:e,cancel:t}){let[i,s]=pe("dropped"),[r,o]=pe(""),[a,l]=pe(!1),c=tn(null);Qm(()=>c.current?.focus(),[]);let u=async h=>{h.preventDefault(),l(!0),await e(i,r.trim()).catch(()=>l(!1))};return v("form",{class:"tools","aria-label":`Decision about ${n}`,onSubmit:u,onKeyDown:h=>h.key==="Escape"&&t(),children:[v("select",{"aria-label":"Decision",value:i,ref:c,onChange:h=>s(h.currentTarget.value),children:[v("option",{value:"dropped",children:"exclude"}),v("option",{value:"kept",children:"keep"})]}),v("input",{"aria-label":"Reason",placeholder:"reason",required:!0,value:r,onInput:h=>o(h.currentTarget.value)}),v("button",{class:"primary",type:"submit",disabled:a,children:"Save"}),v("button",{type:"button",onClick:t,children:"Cancel"})]})}var cR=65536,uR=286,[hR,fR,dR,pR,mR]=[101010256,101075792,117853008,33639248,67324752],ql=()=>new hi({type:"about:blank",title:"The archive of the study cannot be read",status:502}),tf=class n{constructor(e,t,i,s,r){this.path=e;this.etag=t;this.total=i;this.entries=s;this.signal=r}path;etag;total;entries;signal;static async open(e,t){let i=await si(e,{headers:{range:`bytes=-${cR}`},cache:"no-store",signal:t}),s=new DataView(await i.arrayBuffer()),r=i.headers.get("etag")??"",o=Number(/\/(\d+)$/.exec(i.headers.get("content-range")??"")?.[1]??s.byteLength),a=o-s.byteLength,l=s.byteLength-22;for(;l>=0&&s.getUint32(l,!0)!==hR;)l--;if(l<0)throw ql();let[c,u,h]=[s.getUint16(l+10,!0),s.getUint32(l+12,!0),s.getUint32(l+16,!0)];if(l>=20&&s.getUint32(l-20,!0)===dR){let y=Number(s.getBigUint64(l-12,!0))-a;if(y<0||s.getUint32(y,!0)!==fR)throw ql();[c,u,h]=[y+32,y+40,y+48].map(p=>Number(s.getBigUint64(p,!0)))}let f=new n(e,r,o,new Map,t),d=h>=a?new DataView(s.buffer,h-a,u):new DataView(await f.part(h,u)),x=0;for(let y=0;y<c;y++){if(d.getUint32(x,!0)!==pR)throw ql();let[p,m,_]=[28,30,32].map(g=>d.getUint16(x+g,!0)),S=new TextDecoder().decode(new Uint8Array(d.buffer,d.byteOffset+x+46,p)),[b,M]=[d.getUint32(x+20,!0),d.getUint32(x+42,!0)],w=d.getUint32(x+24,!0);for(let g=x+46+p;g+4<=x+46+p+m;){let[T,L]=[d.getUint16(g,!0),d.getUint16(g+2,!0)],P=g+4,D=()=>Number(d.getBigUint64((P+=8)-8,!0));T===1&&(w===4294967295&&D(),b===4294967295&&(b=D()),M===4294967295&&(M=D())),g+=4+L}f.entries.set(S,{offset:M,size:b,nameLength:p,method:d.getUint16(x+10,!0)}),x+=46+p+m+_}return f}has(e){return this.entries.has(e)}names(){return[...this.entries.keys()]}async bytes(e){let t=this.entries.get(e);if(t===void 0||t.method!==0)throw ql();let i=await this.part(t.offset,uR+t.nameLength+t.size),s=new DataView(i);if(s.getUint32(0,!0)!==mR)throw ql();let r=30+s.getUint16(26,!0)+s.getUint16(28,!0);return i.slice(r,r+t.size)}async text(e){return new TextDecoder().decode(await this.bytes(e))}async part(e,t){let i=Math.min(this.total,e+t)-1,s=await si(this.path,{headers:{range:`bytes=${e}-${i}`,"if-range":this.etag},cache:"no-store",signal:this.signal}),r=await s.arrayBuffer();if(s.status===206)return r;if(s.headers.get("etag")!==this.etag)throw new hi({type:"about:blank",title:"The study was computed again: open it anew",status:409});return r.slice(e,i+1)}};async function gR(n,e){let t=new Map,i="";for(;i!==void 0;){let s=await Mt(`v1/jobs${yi({study:n,order:"asc",fields:"id,state,external_ref",page_size:500,page_token:i})}`,e);for(let r of s.jobs)r.external_ref&&t.set(r.external_ref,r);i=s.next_page_token}return t}function my({id:n}){let[e,t]=pe(null),[i,s]=pe(new Map),[r,o]=pe(null),[a,l]=pe(null),[c,u]=pe(0),h=_=>l(Jt(_)),f=Ui();cn(_=>{(async()=>{try{for(;;){let S=await Ni(()=>Mt(`v1/studies/${n}`,_),_);if(t(S),s(await Ni(()=>gR(n,_),_)),Qh(S.state))break;await Hn(2e3,_),_.throwIfAborted()}}catch(S){_.aborted||h(S)}})()},[n,c]);let d=e?.state==="finished"?`${n}/${e.finished_at}`:null;if(cn(_=>{d!==null&&(async()=>{try{let[S,b]=await Promise.all([Ni(()=>tf.open(`v1/studies/${n}/archive`),_),Ni(()=>Mt(`v1/studies/${n}/result`,_),_)]),[M,w]=[iy(await S.text("quality.csv")),ho(await S.bytes("mean.vtk"))];_.aborted||o({archive:S,result:b,mean:w,rows:M,version:d})}catch(S){_.aborted||h(S)}})()},[d]),e===null)return a===null?v("p",{class:"loading",children:"Loading the study …"}):v(Ht,{text:a});let x=_=>(l(null),_.then(S=>{t(b=>({...b,...S})),u(b=>b+1)},S=>{throw h(S),S})),y=_=>`v1/studies/${n}/subjects/${encodeURIComponent(_)}/decision`,p={decide:(_,S,b)=>x(ri("PUT",y(_),{decision:S,reason:b})),undo:_=>x(ri("DELETE",y(_)))},m=e.external_ref??n.slice(-8);return v("article",{class:"study",children:[v("h1",{class:"sub",children:["Study ",e.external_ref??v("code",{children:n})," ",v(tm,{state:e.state})]}),v(vR,{study:e,found:r,cancel:()=>{x(ri("POST",`v1/studies/${n}/cancel`)).catch(()=>{})}}),v(Ht,{text:a}),v("div",{class:"columns",children:[v(yR,{study:e,matches:i,hasResult:r!==null}),v("section",{class:"card",children:[v("h2",{children:"The study"}),v(Xn,{rows:[["Subjects",Re(e.n_subjects)],["Method of the matches",e.method],..._R(r?.result),["Created",`${new Date(e.created_at).toLocaleString()}, ${ds(e.created_at,f)} ago`],...e.finished_at?[["Finished",new Date(e.finished_at).toLocaleString()]]:[],...Object.entries(e.labels).map(([_,S])=>[`Label ${_}`,S])]})]}),e.state==="finished"&&v("section",{class:"card",children:[v("h2",{children:"Report and files"}),v("div",{class:"saves",children:[v("button",{onClick:()=>Af(`v1/studies/${n}/report`,!0).catch(h),children:"Open the report"}),v("button",{onClick:()=>Af(`v1/studies/${n}/archive`,!1).catch(h),children:"Save the archive, ZIP"}),v("button",{onClick:()=>uc(`v1/studies/${n}/result`,`study-${m}.json`).catch(h),children:"Save the result, JSON"})]}),v("p",{class:"soft",children:"The report is one page to print; the archive has all tables, surfaces, maps, modes and labels."})]})]}),v(py,{study:e,rows:r?.rows??null,matches:i,deciding:p,top:r?gy(r.result):0,picture:r&&(async _=>d===r.version?xR(r,_):null),version:r?.version??n}),r!==null&&v(Ot,{children:[v("section",{class:"card section","aria-label":"Maps",children:[v("h2",{children:"Maps on the mean surface"}),v(uy,{archive:r.archive,result:r.result,name:`study-${m}`},r.version)]}),v("section",{class:"card section","aria-label":"Modes",children:[v("h2",{children:"Modes of the shape model"}),v(hy,{archive:r.archive,result:r.result,name:`study-${m}`},r.version)]})]})]})}function _R(n){let e=n?.settings.analysis;return e?[["Effect",e.effect??"none asked for"],...e.adjust?.length?[["Adjusted for",e.adjust.join(", ")]]:[],...e.effect&&e.permutations?[["Permutations",Re(e.permutations)]]:[]]:[]}var gy=({found:n})=>2*Math.sqrt(n.model.variances_mm2.reduce((e,t)=>e+t,0))||1;async function xR({archive:n,mean:e,result:t},i){let s=`subjects/${i}.vtk`;if(!n.has(s))return null;let{geometry:r,arrays:o}=ho(await n.bytes(s)),a=o.normal_displacement,l=gy(t);return{geometry:r,frame:$v(r,e.geometry),coloring:a&&{values:a,low:-l,high:l,map:"blue_red"}}}function vR({study:n,found:e,cancel:t}){let i=n.state==="finished",s=(e?.rows??[]).filter(h=>h.flags!==""&&h.decision==="").length,r=e?.result.found.subjects,o=r&&[`${Re(r.model)} in the shape model`,...r.scored?[`${Re(r.scored)} compared with it`]:[],...r.unreliable?[`${Re(r.unreliable)} left out: match not reliable`]:[],...r.dropped?[`${Re(r.dropped)} excluded by decision`]:[],...r.failed?[`${Re(r.failed)} without a match`]:[]],a=n.state==="failed"||i&&s>0?"bad":i?"good":n.state==="cancelled"?"neutral":"wait",l=nm(n),c=i?e===null?"Finished":s>0?`${Re(s)} of ${Re(n.n_subjects)} to look at`:"No subject stands out":l[0].toUpperCase()+l.slice(1),u=i?s>0?"Look at the subjects at the head of the table; exclude those that are wrong, and keep those that are right.":"Look at the maps, then open the report.":n.state==="failed"?"Correct what is said above, or add subjects, and submit it again.":n.state==="cancelled"?"Submit it again; matches that are finished are not computed twice.":"Quality control, maps and modes appear here when it is finished.";return v("section",{class:`verdict ${a}`,"aria-label":"Verdict",children:[v("span",{class:"mark","aria-hidden":"true",children:{good:"✓",bad:"✕",neutral:"–",wait:"…"}[a]}),v("div",{role:"status",children:[v("p",{class:"title",id:"verdict",children:c}),i&&o&&v("p",{children:[o.join(", "),"."]}),n.error&&v("p",{children:[n.error.title,n.error.detail].filter(Boolean).join(": ")}),v("p",{class:"next",children:[v("b",{children:"Next:"})," ",u]})]}),v("div",{class:"actions",children:!Qh(n.state)&&v("button",{onClick:t,children:"Cancel"})})]})}function yR({study:n,matches:e,hasResult:t}){let{state:i,progress:s}=n,r=i==="finished"?3:i==="modelling"?2:i==="matching"&&s.template_round===0?1:0,o=i==="failed"||i==="cancelled",a=u=>o?t?"done":"not reached":u<r?"done":u===r?"now":"to come",l=[[s.template_round>0?`Template, round ${s.template_round}`:"Template",a(0)],["Matches with all subjects",a(1)],["Shape model, statistics and report",a(2)]],c=new Map;for(let{state:u}of e.values())c.set(u,(c.get(u)??0)+1);return v("section",{class:"card",children:[v("h2",{children:"Steps and matches"}),v("ol",{class:"steps",children:l.map(([u,h])=>v("li",{class:h.replace(" ","-"),"aria-current":h==="now"?"step":void 0,children:[u,": ",v("b",{children:h})]}))}),i==="matching"&&v("p",{children:[v(Yi,{share:s.matches_done/Math.max(1,s.matches_total),label:"Matches that are finished"})," ",Re(s.matches_done)," of ",Re(s.matches_total)]}),v("p",{id:"matches",children:[[...c].map(([u,h])=>`${Re(h)} ${jt(u)}`).join(", ")||"No match yet",". ",v("a",{href:`#/jobs?study=${n.id}`,children:"All matches"})]})]})}function _y({ply:n,fault:e,name:t}){let i=tn(null),s=qr(),[r,o]=pe(null);return xt(()=>{let a=i.current,l;try{l=new Ss({canvas:a,antialias:!0})}catch{o("This browser cannot draw in 3D.");return}let{geometry:c}=Hh(n),u=Ts(c),h=c.boundingSphere?.radius||1,f=new es,d=new Mn(c,new Sl({color:9417945,side:di}));f.add(d,new Al(16777215,8952234,1.4));let x=new Cl(16777215,1.6);if(f.add(x),e){let P=(D,I)=>{let U=new Mn(new yr(h*D,24,16),new qs({color:14024812,transparent:!0,opacity:I,depthTest:!1}));U.position.set(...e),U.renderOrder=1,f.add(U)};P(.03,1),P(.1,.35)}l.setPixelRatio(Math.min(2,devicePixelRatio));let y=new Pi(-1,1,1,-1,-20*h,40*h),[p,m,_]=u.axes;y.up.copy(m);let S=e&&new W(...e).sub(u.center).dot(_)<0?-4:4;y.position.copy(u.center).addScaledVector(_,S*h).addScaledVector(p,1e-4),y.lookAt(u.center);let b=new Pr(y,a);b.target.copy(u.center),b.staticMoving=!0,b.rotateSpeed=3;let M=!0;b.addEventListener("change",()=>M=!0);let w=()=>{let{clientWidth:P,clientHeight:D}=a;if(P===0)return;l.setSize(P,D,!1);let I=Math.max(1.1*(u.high.x-u.low.x)/P,1.2*(u.high.y-u.low.y)/D)/2||h/D;[y.left,y.right,y.top,y.bottom]=[-I*P,I*P,I*D,-I*D],y.updateProjectionMatrix(),b.handleResize(),M=!0},g=new ResizeObserver(w);g.observe(a);let T=0,L=()=>{T=requestAnimationFrame(L),b.update(),M&&(M=!1,x.position.copy(y.position).sub(u.center),l.setClearColor(new it(getComputedStyle(a).getPropertyValue("--canvas").trim()||"#f4f6f8")),l.render(f,y))};return w(),L(),()=>{cancelAnimationFrame(T),g.disconnect(),b.dispose(),c.dispose(),l.dispose()}},[n,e?.join(),s]),r===null?v("canvas",{class:"preview",ref:i,role:"img","aria-label":`The ${t} surface${e?", the place of the fault is marked":""}`}):v("p",{class:"failure",children:r})}var xy=["source","target"],bR=128<<20;function vy(){let[n,e]=pe({source:null,target:null}),[t,i]=pe([]),[s,r]=pe({}),[o,a]=pe("balanced"),[l,c]=pe({}),[u,h]=pe(0),[f,d]=pe(""),[x,y]=pe(""),[p,m]=pe([]),[_,S]=pe(null),[b,M]=pe(null),[w,g]=pe(!1);xt(()=>{Mt("v1/methods").then(({methods:k})=>i(k),k=>S(Jt(k))),Mt("openapi.json").then(({components:k})=>r(k.schemas),k=>S(Jt(k)))},[]);let T=(k,se)=>e($=>({...$,[k]:{...$[k]??{name:"",mesh:null,ply:null,failure:null},...se}})),L=async(k,se,$)=>{M(null),T(k,{name:$,mesh:null,ply:null,failure:null});try{let q=await(await si(`v1/meshes?file_name=${encodeURIComponent(SR($))}`,{method:"POST",body:se,headers:{"content-type":"application/octet-stream"}})).json();if(T(k,{mesh:q}),q.n_bytes>bR)return;let ie=await si(`v1/meshes/${q.id}/surface`).catch(()=>null);ie&&T(k,{ply:await ie.arrayBuffer()})}catch(Z){T(k,{failure:Jt(Z)})}},P=(k,se)=>{if(se.length<2)return se.forEach(ie=>{L(k,ie,ie.name)});let[$,Z]=[...se].sort((ie,ne)=>ie.name.localeCompare(ne.name)),q=/target|fixed|reference/i.test($.name)||/source|moving/i.test(Z.name);L("source",q?Z:$,(q?Z:$).name),L("target",q?$:Z,(q?$:Z).name)},D=()=>xy.forEach(k=>{let se=`${k}.nii.gz`;fetch(cc(`phantoms/${se}`)).then(async $=>{L(k,await $.blob(),se)},$=>T(k,{failure:Jt($)}))}),{source:I,target:U}=n,N=!!(I?.mesh&&U?.mesh),G=async k=>{g(!0),S(null),m([]),M(null);try{let se=x.split(/[\s,]+/).filter(Boolean).map(q=>[q.slice(0,q.indexOf(":")),q.slice(q.indexOf(":")+1)]),$={source:{mesh_id:I.mesh.id},target:{mesh_id:U.mesh.id},parameters:ER({method:o,...l}),priority:u,labels:Object.fromEntries(se),...f===""?{}:{external_ref:f}},Z=await ri("POST",`v1/jobs${k?"?validate_only=true":""}`,$);k?S(""):fr(`jobs/${Z.id}`)}catch(se){if(S(Jt(se)),se instanceof hi){let{errors:$,input:Z,detail:q,title:ie,place_mm:ne}=se.problem;m($??[]),(Z==="source"||Z==="target")&&M({side:Z,text:q??ie,place:ne??null})}}finally{g(!1)}},Y=t.find(({name:k})=>k===o);return v("div",{class:"submit",children:[v("h1",{children:"Submit a pair"}),v("p",{class:"tools",children:[v("span",{children:"The source is moved and bent onto the target, which stays."}),v("button",{onClick:D,children:"Take the two built-in phantoms"})]}),v("div",{class:"pair",children:xy.map(k=>v(MR,{side:k,given:n[k],refusal:b?.side===k?b:null,take:se=>P(k,se)},k))}),v("section",{class:"card",children:[v("h2",{children:"Method"}),v("div",{class:"tools",children:[v("label",{children:["Method"," ",v("select",{value:o,onChange:k=>{a(k.currentTarget.value),c({})},children:t.map(({name:k})=>v("option",{value:k,children:k}))})]}),v("label",{children:["Priority ",v("input",{type:"number",min:-100,max:100,value:u,onInput:k=>h(Number(k.currentTarget.value))})]}),v("label",{children:["Reference ",v("input",{value:f,onInput:k=>d(k.currentTarget.value)})]}),v("label",{children:["Labels ",v("input",{placeholder:"study:baseline",value:x,onInput:k=>y(k.currentTarget.value)})]})]}),v("p",{children:Y?.description}),Y&&v(wR,{method:Y,schemas:s,changed:l,change:c,faults:p})]}),_===""?v("p",{class:"success",role:"status",children:"These files and parameters are accepted."}):v(Ht,{text:_}),v("div",{class:"tools send",children:[v("button",{class:"primary",disabled:!N||w,onClick:()=>{G(!1)},children:"Match them"}),v("button",{disabled:!N||w,onClick:()=>{G(!0)},children:"Only check"}),!N&&v("span",{class:"hint",children:"Both surfaces are needed."})]})]})}var SR=n=>`file${/(\.[A-Za-z0-9]{1,8}){1,2}$/.exec(n)?.[0]??""}`;function MR({side:n,given:e,refusal:t,take:i}){let[s,r]=pe(!1),o=e?.mesh,a=o?.report?.topology??o?.problem?.topology,l=t?.place??o?.problem?.place_mm??null,c=t?.text??(o?.problem?o.problem.detail??o.problem.title:null);return v("section",{class:`card drop ${s?"over":""}`,"aria-label":n,onDragOver:u=>{u.preventDefault(),r(!0)},onDragLeave:()=>r(!1),onDrop:u=>{u.preventDefault(),r(!1),i([...u.dataTransfer?.files??[]])},children:[v("h2",{children:n==="source"?"Source":"Target"}),v("label",{class:"file",children:[e===null?"Drop a file here, or choose one: ":`${e.name}${o?`, ${hc(o.n_bytes)}`:""} `,v("input",{type:"file","aria-label":`File of the ${n}`,onChange:u=>i([...u.currentTarget.files??[]])})]}),e===null&&v("p",{class:"hint",children:"Surfaces: GIFTI, FreeSurfer, PLY, STL, VTK, VTP, OBJ, OFF, MZ3. Label volumes: NIfTI, MGZ, NRRD, MetaImage, DICOM SEG."}),e!==null&&o===null&&e.failure===null&&v("p",{class:"loading",children:"Sending and checking …"}),v(Ht,{text:e?.failure??null}),c&&v("p",{class:"failure",role:"alert",children:[v("b",{children:"With default parameters it is refused:"})," ",c,l&&". The place is marked."]}),o&&!c&&v("p",{class:"success",role:"status",children:"✓ It can be matched."}),e?.ply&&v(_y,{ply:e.ply,fault:l,name:n}),a&&v(Xn,{rows:[["Format",o?.report?.format??"–"],["Vertices",Re(a.n_vertices)],["Faces",Re(a.n_faces)],["Pieces",Re(a.n_components)],["Genus",a.genus===null?"open":Re(a.genus)],["Boundary edges",Re(a.n_boundary_edges)],["Edges with more than two faces",Re(a.n_nonmanifold_edges)],["Area",`${Re(a.area_mm2)} mm²`],["Volume",a.volume_mm3===null?"–":`${Re(a.volume_mm3)} mm³`],["Repairs",o?.report?.repairs.length?String(o.report.repairs.length):"none"]]})]})}function wR({method:n,schemas:e,changed:t,change:i,faults:s}){let r=u=>{let h=u.$ref?.split("/").at(-1),f=h===void 0?void 0:e[h];if(f)return{...r(f),description:u.description??f.description};let d=[...u.oneOf??[],...u.anyOf??[]].filter(x=>x.type!=="null");return d.length===1?{...r(d[0]),description:u.description??d[0].description,type:[String(r(d[0]).type),"null"]}:u},o=u=>u.reduce((h,f)=>h===null||typeof h!="object"?void 0:h[f],n.defaults),a=(u,h,f)=>{let d={...t,[u]:h};JSON.stringify(h)===JSON.stringify(f)&&delete d[u],i(d)},l=(u,h)=>Object.entries(r(u).properties??{}).map(([f,d])=>{let x=r(d),y=[...h,f];if(y.join()==="method")return null;if(x.properties)return v("fieldset",{children:[v("legend",{children:jt(f)}),x.description&&v("p",{class:"soft",children:x.description}),l(x,y)]},f);let p=y.join("."),m=o(y),_=p in t?t[p]:m,S=s.find(({pointer:b})=>b.replace(/^\/parameters/,"")===`/${y.join("/")}`);return v(AR,{name:p,schema:x,value:_,isChanged:p in t,fault:S,set:b=>a(p,b,m)},p)}),c=Object.keys(t).length;return v("details",{children:[v("summary",{children:["Parameters",c>0&&`: ${c} changed`]}),c>0&&v("button",{onClick:()=>i({}),children:"All as the method sets them"}),v("div",{class:"fields",children:l({$ref:"PartialParameters"},[])})]})}var TR=[[/_mm$/,"mm"],[/_deg$/,"°"],[/_ms$/,"ms"],[/_s$/,"s"],[/_bytes$/,"bytes"]];function AR({name:n,schema:e,value:t,isChanged:i,fault:s,set:r}){let[o,a]=pe(null),l=[e.type??[]].flat(),c=TR.find(([y])=>y.test(n))?.[1],u=l.includes("number")||l.includes("integer"),h=e.enum??e.oneOf?.flatMap(y=>y.const??y.enum??[]),f=jt(n.split(".").at(-1)),d;h&&h.length>0&&!l.includes("array")?d=v("select",{value:t===null?"null":String(t),onChange:y=>r(y.currentTarget.value==="null"?null:y.currentTarget.value),children:[(l.includes("null")||t===null)&&v("option",{value:"null",children:"not set"}),h.map(y=>v("option",{value:String(y),children:String(y)}))]}):l.includes("boolean")?d=v("select",{value:String(t),onChange:y=>r(y.currentTarget.value==="null"?null:y.currentTarget.value==="true"),children:[(l.includes("null")||t===null)&&v("option",{value:"null",children:"not set"}),v("option",{value:"true",children:"yes"}),v("option",{value:"false",children:"no"})]}):u?d=v("input",{type:"number",step:l.includes("integer")?e.multipleOf??1:"any",min:e.minimum,max:e.maximum,placeholder:l.includes("null")?"not set":void 0,value:t==null?"":String(t),onChange:y=>r(y.currentTarget.value===""?null:Number(y.currentTarget.value))}):d=v("input",{value:o??JSON.stringify(t??null),spellcheck:!1,onInput:y=>a(y.currentTarget.value),onChange:y=>{try{r(JSON.parse(y.currentTarget.value)),a(null)}catch{}}});let x=[e.minimum!==void 0&&`at least ${Re(e.minimum)}`,e.maximum!==void 0&&`at most ${Re(e.maximum)}`].filter(Boolean).join(", ");return v("div",{class:`field ${i?"changed":""}`,children:[v("label",{children:[v("span",{children:[f," ",c&&v("span",{class:"soft",children:["(",c,")"]})]})," ",d]}),v("p",{class:"soft",children:[e.description," ",x&&`(${x})`]}),s&&v(Ht,{text:s.detail})]})}function ER(n){let e={};for(let[t,i]of Object.entries(n)){let s=t.split("."),r=s.pop(),o=s.reduce((a,l)=>a[l]??={},e);o[r]=i}return e}var yy=[["jobs","Jobs"],["submit","Submit"],["batches","Batches"],["studies","Studies"],["operations","Operations"]],by="homolog-theme";function CR(){let[n,e]=pe(localStorage.getItem(by)??"auto");return xt(()=>{n==="auto"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=n,localStorage.setItem(by,n),window.dispatchEvent(new Event("theme"))},[n]),[n,e]}function RR({done:n}){let[e,t]=pe(""),[i,s]=pe(null);return v("form",{class:"card key",onSubmit:async o=>{o.preventDefault(),Fr.set(e.trim());try{await Mt("v1/jobs?page_size=1"),n()}catch(a){Fr.set(null),s(Jt(a))}},children:[v("h1",{children:"This service asks for a key"}),v("p",{children:["Paste an API key of your tenant. It is kept for this tab only, until you close it. Whoever operates the service creates keys with ",v("code",{children:"homolog keys create"}),"."]}),v("label",{children:["API key ",v("input",{type:"password",autocomplete:"off",spellcheck:!1,value:e,onInput:o=>t(o.currentTarget.value),required:!0})]}),v(Ht,{text:i}),v("button",{class:"primary",type:"submit",children:"Open"})]})}function PR(){let{path:n,query:e}=K0(),[t,i]=pe(!1),[s,r]=pe(""),[o,a]=CR();xt(()=>tg(()=>i(!0)),[]),xt(()=>{Mt("healthz").then(({version:h})=>r(h),()=>{})},[]);let[l="jobs",c]=n;xt(()=>{let h=yy.find(([f])=>f===l)?.[1]??"Dashboard";document.title=c?`${{batches:"Batch",studies:"Study"}[l]??"Job"} ${c.slice(-8)} · homolog`:`${h} · homolog`},[l,c]);let u;return t?u=v(RR,{done:()=>i(!1)}):l==="jobs"&&c!==void 0?u=v(Qv,{id:c},c):l==="jobs"?u=v(t_,{query:e}):l==="submit"?u=v(vy,{}):l==="batches"&&c!==void 0?u=v(r_,{id:c},c):l==="batches"?u=v(s_,{}):l==="studies"&&c!==void 0?u=v(my,{id:c},c):l==="studies"?u=v(ny,{}):l==="operations"?u=v(ty,{}):u=v("p",{class:"failure",children:"There is no view of this name. Choose one above."}),v(Ot,{children:[v("a",{class:"skip",href:"#main",onClick:h=>(h.preventDefault(),document.getElementById("main")?.focus()),children:"Skip to the content"}),v("header",{children:[v("a",{class:"name",href:"#/jobs",children:"homolog"}),v("nav",{"aria-label":"Views",children:yy.map(([h,f])=>v("a",{href:`#/${h}`,"aria-current":h===l?"page":void 0,children:f}))}),v("span",{class:"end",children:[v("label",{children:[v("span",{class:"quiet",children:"Theme"})," ",v("select",{value:o,onChange:h=>a(h.currentTarget.value),children:[v("option",{value:"auto",children:"auto"}),v("option",{value:"light",children:"light"}),v("option",{value:"dark",children:"dark"})]})]}),Fr.get()!==null&&v("button",{onClick:()=>{Fr.set(null),i(!0)},children:"Forget key"})]})]}),v("main",{id:"main",tabIndex:-1,children:u}),v("footer",{children:["homolog ",s," · ",v("a",{href:new URL("docs/",document.baseURI.split("#")[0]).href,children:"API"})," · ",v("a",{href:new URL("assets/licenses.txt",document.baseURI.split("#")[0]).href,children:"licenses"})]})]})}Gm(v(PR,{}),document.getElementById("app"));
