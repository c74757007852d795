// made from 868500a224c8ad14423d27a2ae969b0ea5b72fc4c32c1a9c1f448400abe28215 by `npm run build` in web_page
var Ft=Object.defineProperty;var Jt=Object.getOwnPropertyDescriptor;var p=(r,e,t,s)=>{for(var i=s>1?void 0:s?Jt(e,t):e,o=r.length-1,n;o>=0;o--)(n=r[o])&&(i=(s?n(e,t,i):n(i))||i);return s&&i&&Ft(e,t,i),i};var F=globalThis,G=F.ShadowRoot&&(F.ShadyCSS===void 0||F.ShadyCSS.nativeShadow)&&"adoptedStyleSheets"in Document.prototype&&"replace"in CSSStyleSheet.prototype,bt=Symbol(),gt=new WeakMap,J=class{constructor(e,t,s){if(this._$cssResult$=!0,s!==bt)throw Error("CSSResult is not constructable. Use `unsafeCSS` or `css` instead.");this.cssText=e,this.t=t}get styleSheet(){let e=this.o,t=this.t;if(G&&e===void 0){let s=t!==void 0&&t.length===1;s&&(e=gt.get(t)),e===void 0&&((this.o=e=new CSSStyleSheet).replaceSync(this.cssText),s&&gt.set(t,e))}return e}toString(){return this.cssText}},yt=r=>new J(typeof r=="string"?r:r+"",void 0,bt);var _t=(r,e)=>{if(G)r.adoptedStyleSheets=e.map(t=>t instanceof CSSStyleSheet?t:t.styleSheet);else for(let t of e){let s=document.createElement("style"),i=F.litNonce;i!==void 0&&s.setAttribute("nonce",i),s.textContent=t.cssText,r.appendChild(s)}},ct=G?r=>r:r=>r instanceof CSSStyleSheet?(e=>{let t="";for(let s of e.cssRules)t+=s.cssText;return yt(t)})(r):r;var{is:Gt,defineProperty:Yt,getOwnPropertyDescriptor:Qt,getOwnPropertyNames:Zt,getOwnPropertySymbols:Vt,getPrototypeOf:Xt}=Object,Y=globalThis,Et=Y.trustedTypes,te=Et?Et.emptyScript:"",ee=Y.reactiveElementPolyfillSupport,B=(r,e)=>r,q={toAttribute(r,e){switch(e){case Boolean:r=r?te:null;break;case Object:case Array:r=r==null?r:JSON.stringify(r)}return r},fromAttribute(r,e){let t=r;switch(e){case Boolean:t=r!==null;break;case Number:t=r===null?null:Number(r);break;case Object:case Array:try{t=JSON.parse(r)}catch{t=null}}return t}},Q=(r,e)=>!Gt(r,e),At={attribute:!0,type:String,converter:q,reflect:!1,useDefault:!1,hasChanged:Q};Symbol.metadata??=Symbol("metadata"),Y.litPropertyMetadata??=new WeakMap;var k=class extends HTMLElement{static addInitializer(e){this._$Ei(),(this.l??=[]).push(e)}static get observedAttributes(){return this.finalize(),this._$Eh&&[...this._$Eh.keys()]}static createProperty(e,t=At){if(t.state&&(t.attribute=!1),this._$Ei(),this.prototype.hasOwnProperty(e)&&((t=Object.create(t)).wrapped=!0),this.elementProperties.set(e,t),!t.noAccessor){let s=Symbol(),i=this.getPropertyDescriptor(e,s,t);i!==void 0&&Yt(this.prototype,e,i)}}static getPropertyDescriptor(e,t,s){let{get:i,set:o}=Qt(this.prototype,e)??{get(){return this[t]},set(n){this[t]=n}};return{get:i,set(n){let c=i?.call(this);o?.call(this,n),this.requestUpdate(e,c,s)},configurable:!0,enumerable:!0}}static getPropertyOptions(e){return this.elementProperties.get(e)??At}static _$Ei(){if(this.hasOwnProperty(B("elementProperties")))return;let e=Xt(this);e.finalize(),e.l!==void 0&&(this.l=[...e.l]),this.elementProperties=new Map(e.elementProperties)}static finalize(){if(this.hasOwnProperty(B("finalized")))return;if(this.finalized=!0,this._$Ei(),this.hasOwnProperty(B("properties"))){let t=this.properties,s=[...Zt(t),...Vt(t)];for(let i of s)this.createProperty(i,t[i])}let e=this[Symbol.metadata];if(e!==null){let t=litPropertyMetadata.get(e);if(t!==void 0)for(let[s,i]of t)this.elementProperties.set(s,i)}this._$Eh=new Map;for(let[t,s]of this.elementProperties){let i=this._$Eu(t,s);i!==void 0&&this._$Eh.set(i,t)}this.elementStyles=this.finalizeStyles(this.styles)}static finalizeStyles(e){let t=[];if(Array.isArray(e)){let s=new Set(e.flat(1/0).reverse());for(let i of s)t.unshift(ct(i))}else e!==void 0&&t.push(ct(e));return t}static _$Eu(e,t){let s=t.attribute;return s===!1?void 0:typeof s=="string"?s:typeof e=="string"?e.toLowerCase():void 0}constructor(){super(),this._$Ep=void 0,this.isUpdatePending=!1,this.hasUpdated=!1,this._$Em=null,this._$Ev()}_$Ev(){this._$ES=new Promise(e=>this.enableUpdating=e),this._$AL=new Map,this._$E_(),this.requestUpdate(),this.constructor.l?.forEach(e=>e(this))}addController(e){(this._$EO??=new Set).add(e),this.renderRoot!==void 0&&this.isConnected&&e.hostConnected?.()}removeController(e){this._$EO?.delete(e)}_$E_(){let e=new Map,t=this.constructor.elementProperties;for(let s of t.keys())this.hasOwnProperty(s)&&(e.set(s,this[s]),delete this[s]);e.size>0&&(this._$Ep=e)}createRenderRoot(){let e=this.shadowRoot??this.attachShadow(this.constructor.shadowRootOptions);return _t(e,this.constructor.elementStyles),e}connectedCallback(){this.renderRoot??=this.createRenderRoot(),this.enableUpdating(!0),this._$EO?.forEach(e=>e.hostConnected?.())}enableUpdating(e){}disconnectedCallback(){this._$EO?.forEach(e=>e.hostDisconnected?.())}attributeChangedCallback(e,t,s){this._$AK(e,s)}_$ET(e,t){let s=this.constructor.elementProperties.get(e),i=this.constructor._$Eu(e,s);if(i!==void 0&&s.reflect===!0){let o=(s.converter?.toAttribute!==void 0?s.converter:q).toAttribute(t,s.type);this._$Em=e,o==null?this.removeAttribute(i):this.setAttribute(i,o),this._$Em=null}}_$AK(e,t){let s=this.constructor,i=s._$Eh.get(e);if(i!==void 0&&this._$Em!==i){let o=s.getPropertyOptions(i),n=typeof o.converter=="function"?{fromAttribute:o.converter}:o.converter?.fromAttribute!==void 0?o.converter:q;this._$Em=i;let c=n.fromAttribute(t,o.type);this[i]=c??this._$Ej?.get(i)??c,this._$Em=null}}requestUpdate(e,t,s,i=!1,o){if(e!==void 0){let n=this.constructor;if(i===!1&&(o=this[e]),s??=n.getPropertyOptions(e),!((s.hasChanged??Q)(o,t)||s.useDefault&&s.reflect&&o===this._$Ej?.get(e)&&!this.hasAttribute(n._$Eu(e,s))))return;this.C(e,t,s)}this.isUpdatePending===!1&&(this._$ES=this._$EP())}C(e,t,{useDefault:s,reflect:i,wrapped:o},n){s&&!(this._$Ej??=new Map).has(e)&&(this._$Ej.set(e,n??t??this[e]),o!==!0||n!==void 0)||(this._$AL.has(e)||(this.hasUpdated||s||(t=void 0),this._$AL.set(e,t)),i===!0&&this._$Em!==e&&(this._$Eq??=new Set).add(e))}async _$EP(){this.isUpdatePending=!0;try{await this._$ES}catch(t){Promise.reject(t)}let e=this.scheduleUpdate();return e!=null&&await e,!this.isUpdatePending}scheduleUpdate(){return this.performUpdate()}performUpdate(){if(!this.isUpdatePending)return;if(!this.hasUpdated){if(this.renderRoot??=this.createRenderRoot(),this._$Ep){for(let[i,o]of this._$Ep)this[i]=o;this._$Ep=void 0}let s=this.constructor.elementProperties;if(s.size>0)for(let[i,o]of s){let{wrapped:n}=o,c=this[i];n!==!0||this._$AL.has(i)||c===void 0||this.C(i,void 0,o,c)}}let e=!1,t=this._$AL;try{e=this.shouldUpdate(t),e?(this.willUpdate(t),this._$EO?.forEach(s=>s.hostUpdate?.()),this.update(t)):this._$EM()}catch(s){throw e=!1,this._$EM(),s}e&&this._$AE(t)}willUpdate(e){}_$AE(e){this._$EO?.forEach(t=>t.hostUpdated?.()),this.hasUpdated||(this.hasUpdated=!0,this.firstUpdated(e)),this.updated(e)}_$EM(){this._$AL=new Map,this.isUpdatePending=!1}get updateComplete(){return this.getUpdateComplete()}getUpdateComplete(){return this._$ES}shouldUpdate(e){return!0}update(e){this._$Eq&&=this._$Eq.forEach(t=>this._$ET(t,this[t])),this._$EM()}updated(e){}firstUpdated(e){}};k.elementStyles=[],k.shadowRootOptions={mode:"open"},k[B("elementProperties")]=new Map,k[B("finalized")]=new Map,ee?.({ReactiveElement:k}),(Y.reactiveElementVersions??=[]).push("2.1.2");var ht=globalThis,wt=r=>r,Z=ht.trustedTypes,kt=Z?Z.createPolicy("lit-html",{createHTML:r=>r}):void 0,pt="$lit$",S=`lit$${Math.random().toFixed(9).slice(2)}$`,ut="?"+S,se=`<${ut}>`,L=document,z=()=>L.createComment(""),I=r=>r===null||typeof r!="object"&&typeof r!="function",mt=Array.isArray,Mt=r=>mt(r)||typeof r?.[Symbol.iterator]=="function",dt=`[ 	
\f\r]`,W=/<(?:(!--|\/[^a-zA-Z])|(\/?[a-zA-Z][^>\s]*)|(\/?$))/g,St=/-->/g,xt=/>/g,M=RegExp(`>|${dt}(?:([^\\s"'>=/]+)(${dt}*=${dt}*(?:[^ 	
\f\r"'\`<>=]|("|')|))|$)`,"g"),Ct=/'/g,Pt=/"/g,Rt=/^(?:script|style|textarea|title)$/i,$t=r=>(e,...t)=>({_$litType$:r,strings:e,values:t}),l=$t(1),ve=$t(2),ge=$t(3),_=Symbol.for("lit-noChange"),d=Symbol.for("lit-nothing"),Tt=new WeakMap,R=L.createTreeWalker(L,129);function Lt(r,e){if(!mt(r)||!r.hasOwnProperty("raw"))throw Error("invalid template strings array");return kt!==void 0?kt.createHTML(e):e}var Ot=(r,e)=>{let t=r.length-1,s=[],i,o=e===2?"<svg>":e===3?"<math>":"",n=W;for(let c=0;c<t;c++){let a=r[c],m,f,h=-1,$=0;for(;$<a.length&&(n.lastIndex=$,f=n.exec(a),f!==null);)$=n.lastIndex,n===W?f[1]==="!--"?n=St:f[1]!==void 0?n=xt:f[2]!==void 0?(Rt.test(f[2])&&(i=RegExp("</"+f[2],"g")),n=M):f[3]!==void 0&&(n=M):n===M?f[0]===">"?(n=i??W,h=-1):f[1]===void 0?h=-2:(h=n.lastIndex-f[2].length,m=f[1],n=f[3]===void 0?M:f[3]==='"'?Pt:Ct):n===Pt||n===Ct?n=M:n===St||n===xt?n=W:(n=M,i=void 0);let u=n===M&&r[c+1].startsWith("/>")?" ":"";o+=n===W?a+se:h>=0?(s.push(m),a.slice(0,h)+pt+a.slice(h)+S+u):a+S+(h===-2?c:u)}return[Lt(r,o+(r[t]||"<?>")+(e===2?"</svg>":e===3?"</math>":"")),s]},K=class r{constructor({strings:e,_$litType$:t},s){let i;this.parts=[];let o=0,n=0,c=e.length-1,a=this.parts,[m,f]=Ot(e,t);if(this.el=r.createElement(m,s),R.currentNode=this.el.content,t===2||t===3){let h=this.el.content.firstChild;h.replaceWith(...h.childNodes)}for(;(i=R.nextNode())!==null&&a.length<c;){if(i.nodeType===1){if(i.hasAttributes())for(let h of i.getAttributeNames())if(h.endsWith(pt)){let $=f[n++],u=i.getAttribute(h).split(S),v=/([.?@])?(.*)/.exec($);a.push({type:1,index:o,name:v[2],strings:u,ctor:v[1]==="."?X:v[1]==="?"?tt:v[1]==="@"?et:H}),i.removeAttribute(h)}else h.startsWith(S)&&(a.push({type:6,index:o}),i.removeAttribute(h));if(Rt.test(i.tagName)){let h=i.textContent.split(S),$=h.length-1;if($>0){i.textContent=Z?Z.emptyScript:"";for(let u=0;u<$;u++)i.append(h[u],z()),R.nextNode(),a.push({type:2,index:++o});i.append(h[$],z())}}}else if(i.nodeType===8)if(i.data===ut)a.push({type:2,index:o});else{let h=-1;for(;(h=i.data.indexOf(S,h+1))!==-1;)a.push({type:7,index:o}),h+=S.length-1}o++}}static createElement(e,t){let s=L.createElement("template");return s.innerHTML=e,s}};function O(r,e,t=r,s){if(e===_)return e;let i=s!==void 0?t._$Co?.[s]:t._$Cl,o=I(e)?void 0:e._$litDirective$;return i?.constructor!==o&&(i?._$AO?.(!1),o===void 0?i=void 0:(i=new o(r),i._$AT(r,t,s)),s!==void 0?(t._$Co??=[])[s]=i:t._$Cl=i),i!==void 0&&(e=O(r,i._$AS(r,e.values),i,s)),e}var V=class{constructor(e,t){this._$AV=[],this._$AN=void 0,this._$AD=e,this._$AM=t}get parentNode(){return this._$AM.parentNode}get _$AU(){return this._$AM._$AU}u(e){let{el:{content:t},parts:s}=this._$AD,i=(e?.creationScope??L).importNode(t,!0);R.currentNode=i;let o=R.nextNode(),n=0,c=0,a=s[0];for(;a!==void 0;){if(n===a.index){let m;a.type===2?m=new U(o,o.nextSibling,this,e):a.type===1?m=new a.ctor(o,a.name,a.strings,this,e):a.type===6&&(m=new st(o,this,e)),this._$AV.push(m),a=s[++c]}n!==a?.index&&(o=R.nextNode(),n++)}return R.currentNode=L,i}p(e){let t=0;for(let s of this._$AV)s!==void 0&&(s.strings!==void 0?(s._$AI(e,s,t),t+=s.strings.length-2):s._$AI(e[t])),t++}},U=class r{get _$AU(){return this._$AM?._$AU??this._$Cv}constructor(e,t,s,i){this.type=2,this._$AH=d,this._$AN=void 0,this._$AA=e,this._$AB=t,this._$AM=s,this.options=i,this._$Cv=i?.isConnected??!0}get parentNode(){let e=this._$AA.parentNode,t=this._$AM;return t!==void 0&&e?.nodeType===11&&(e=t.parentNode),e}get startNode(){return this._$AA}get endNode(){return this._$AB}_$AI(e,t=this){e=O(this,e,t),I(e)?e===d||e==null||e===""?(this._$AH!==d&&this._$AR(),this._$AH=d):e!==this._$AH&&e!==_&&this._(e):e._$litType$!==void 0?this.$(e):e.nodeType!==void 0?this.T(e):Mt(e)?this.k(e):this._(e)}O(e){return this._$AA.parentNode.insertBefore(e,this._$AB)}T(e){this._$AH!==e&&(this._$AR(),this._$AH=this.O(e))}_(e){this._$AH!==d&&I(this._$AH)?this._$AA.nextSibling.data=e:this.T(L.createTextNode(e)),this._$AH=e}$(e){let{values:t,_$litType$:s}=e,i=typeof s=="number"?this._$AC(e):(s.el===void 0&&(s.el=K.createElement(Lt(s.h,s.h[0]),this.options)),s);if(this._$AH?._$AD===i)this._$AH.p(t);else{let o=new V(i,this),n=o.u(this.options);o.p(t),this.T(n),this._$AH=o}}_$AC(e){let t=Tt.get(e.strings);return t===void 0&&Tt.set(e.strings,t=new K(e)),t}k(e){mt(this._$AH)||(this._$AH=[],this._$AR());let t=this._$AH,s,i=0;for(let o of e)i===t.length?t.push(s=new r(this.O(z()),this.O(z()),this,this.options)):s=t[i],s._$AI(o),i++;i<t.length&&(this._$AR(s&&s._$AB.nextSibling,i),t.length=i)}_$AR(e=this._$AA.nextSibling,t){for(this._$AP?.(!1,!0,t);e!==this._$AB;){let s=wt(e).nextSibling;wt(e).remove(),e=s}}setConnected(e){this._$AM===void 0&&(this._$Cv=e,this._$AP?.(e))}},H=class{get tagName(){return this.element.tagName}get _$AU(){return this._$AM._$AU}constructor(e,t,s,i,o){this.type=1,this._$AH=d,this._$AN=void 0,this.element=e,this.name=t,this._$AM=i,this.options=o,s.length>2||s[0]!==""||s[1]!==""?(this._$AH=Array(s.length-1).fill(new String),this.strings=s):this._$AH=d}_$AI(e,t=this,s,i){let o=this.strings,n=!1;if(o===void 0)e=O(this,e,t,0),n=!I(e)||e!==this._$AH&&e!==_,n&&(this._$AH=e);else{let c=e,a,m;for(e=o[0],a=0;a<o.length-1;a++)m=O(this,c[s+a],t,a),m===_&&(m=this._$AH[a]),n||=!I(m)||m!==this._$AH[a],m===d?e=d:e!==d&&(e+=(m??"")+o[a+1]),this._$AH[a]=m}n&&!i&&this.j(e)}j(e){e===d?this.element.removeAttribute(this.name):this.element.setAttribute(this.name,e??"")}},X=class extends H{constructor(){super(...arguments),this.type=3}j(e){this.element[this.name]=e===d?void 0:e}},tt=class extends H{constructor(){super(...arguments),this.type=4}j(e){this.element.toggleAttribute(this.name,!!e&&e!==d)}},et=class extends H{constructor(e,t,s,i,o){super(e,t,s,i,o),this.type=5}_$AI(e,t=this){if((e=O(this,e,t,0)??d)===_)return;let s=this._$AH,i=e===d&&s!==d||e.capture!==s.capture||e.once!==s.once||e.passive!==s.passive,o=e!==d&&(s===d||i);i&&this.element.removeEventListener(this.name,this,s),o&&this.element.addEventListener(this.name,this,e),this._$AH=e}handleEvent(e){typeof this._$AH=="function"?this._$AH.call(this.options?.host??this.element,e):this._$AH.handleEvent(e)}},st=class{constructor(e,t,s){this.element=e,this.type=6,this._$AN=void 0,this._$AM=t,this.options=s}get _$AU(){return this._$AM._$AU}_$AI(e){O(this,e)}},Ht={M:pt,P:S,A:ut,C:1,L:Ot,R:V,D:Mt,V:O,I:U,H,N:tt,U:et,B:X,F:st},ie=ht.litHtmlPolyfillSupport;ie?.(K,U),(ht.litHtmlVersions??=[]).push("3.3.3");var Dt=(r,e,t)=>{let s=t?.renderBefore??e,i=s._$litPart$;if(i===void 0){let o=t?.renderBefore??null;s._$litPart$=i=new U(e.insertBefore(z(),o),o,void 0,t??{})}return i._$AI(r),i};var ft=globalThis,b=class extends k{constructor(){super(...arguments),this.renderOptions={host:this},this._$Do=void 0}createRenderRoot(){let e=super.createRenderRoot();return this.renderOptions.renderBefore??=e.firstChild,e}update(e){let t=this.render();this.hasUpdated||(this.renderOptions.isConnected=this.isConnected),super.update(e),this._$Do=Dt(t,this.renderRoot,this.renderOptions)}connectedCallback(){super.connectedCallback(),this._$Do?.setConnected(!0)}disconnectedCallback(){super.disconnectedCallback(),this._$Do?.setConnected(!1)}render(){return _}};b._$litElement$=!0,b.finalized=!0,ft.litElementHydrateSupport?.({LitElement:b});var re=ft.litElementPolyfillSupport;re?.({LitElement:b});(ft.litElementVersions??=[]).push("4.2.2");var A=r=>(e,t)=>{t!==void 0?t.addInitializer(()=>{customElements.define(r,e)}):customElements.define(r,e)};var oe={attribute:!0,type:String,converter:q,reflect:!1,hasChanged:Q},ne=(r=oe,e,t)=>{let{kind:s,metadata:i}=t,o=globalThis.litPropertyMetadata.get(i);if(o===void 0&&globalThis.litPropertyMetadata.set(i,o=new Map),s==="setter"&&((r=Object.create(r)).wrapped=!0),o.set(t.name,r),s==="accessor"){let{name:n}=t;return{set(c){let a=e.get.call(this);e.set.call(this,c),this.requestUpdate(n,a,r,!0,c)},init(c){return c!==void 0&&this.C(n,void 0,r,c),c}}}if(s==="setter"){let{name:n}=t;return function(c){let a=this[n];e.call(this,c),this.requestUpdate(n,a,r,!0,c)}}throw Error("Unsupported decorator location: "+s)};function y(r){return(e,t)=>typeof t=="object"?ne(r,e,t):((s,i,o)=>{let n=i.hasOwnProperty(o);return i.constructor.createProperty(o,s),n?Object.getOwnPropertyDescriptor(i,o):void 0})(r,e,t)}function g(r){return y({...r,state:!0,attribute:!1})}var rt={ATTRIBUTE:1,CHILD:2,PROPERTY:3,BOOLEAN_ATTRIBUTE:4,EVENT:5,ELEMENT:6},ot=r=>(...e)=>({_$litDirective$:r,values:e}),N=class{constructor(e){}get _$AU(){return this._$AM._$AU}_$AT(e,t,s){this._$Ct=e,this._$AM=t,this._$Ci=s}_$AS(e,t){return this.update(e,t)}update(e,t){return this.render(...t)}};var Ut=ot(class extends N{constructor(r){if(super(r),r.type!==rt.ATTRIBUTE||r.name!=="class"||r.strings?.length>2)throw Error("`classMap()` can only be used in the `class` attribute and must be the only part in the attribute.")}render(r){return" "+Object.keys(r).filter(e=>r[e]).join(" ")+" "}update(r,[e]){if(this.st===void 0){this.st=new Set,r.strings!==void 0&&(this.nt=new Set(r.strings.join(" ").split(/\s/).filter(s=>s!=="")));for(let s in e)e[s]&&!this.nt?.has(s)&&this.st.add(s);return this.render(e)}let t=r.element.classList;for(let s of this.st)s in e||(t.remove(s),this.st.delete(s));for(let s in e){let i=!!e[s];i===this.st.has(s)||this.nt?.has(s)||(i?(t.add(s),this.st.add(s)):(t.remove(s),this.st.delete(s)))}return _}});var{I:ae}=Ht,Nt=r=>r;var jt=()=>document.createComment(""),j=(r,e,t)=>{let s=r._$AA.parentNode,i=e===void 0?r._$AB:e._$AA;if(t===void 0){let o=s.insertBefore(jt(),i),n=s.insertBefore(jt(),i);t=new ae(o,n,r,r.options)}else{let o=t._$AB.nextSibling,n=t._$AM,c=n!==r;if(c){let a;t._$AQ?.(r),t._$AM=r,t._$AP!==void 0&&(a=r._$AU)!==n._$AU&&t._$AP(a)}if(o!==i||c){let a=t._$AA;for(;a!==o;){let m=Nt(a).nextSibling;Nt(s).insertBefore(a,i),a=m}}}return t},C=(r,e,t=r)=>(r._$AI(e,t),r),le={},Bt=(r,e=le)=>r._$AH=e,qt=r=>r._$AH,nt=r=>{r._$AR(),r._$AA.remove()};var Wt=(r,e,t)=>{let s=new Map;for(let i=e;i<=t;i++)s.set(r[i],i);return s},zt=ot(class extends N{constructor(r){if(super(r),r.type!==rt.CHILD)throw Error("repeat() can only be used in text expressions")}dt(r,e,t){let s;t===void 0?t=e:e!==void 0&&(s=e);let i=[],o=[],n=0;for(let c of r)i[n]=s?s(c,n):n,o[n]=t(c,n),n++;return{values:o,keys:i}}render(r,e,t){return this.dt(r,e,t).values}update(r,[e,t,s]){let i=qt(r),{values:o,keys:n}=this.dt(e,t,s);if(!Array.isArray(i))return this.ut=n,o;let c=this.ut??=[],a=[],m,f,h=0,$=i.length-1,u=0,v=o.length-1;for(;h<=$&&u<=v;)if(i[h]===null)h++;else if(i[$]===null)$--;else if(c[h]===n[u])a[u]=C(i[h],o[u]),h++,u++;else if(c[$]===n[v])a[v]=C(i[$],o[v]),$--,v--;else if(c[h]===n[v])a[v]=C(i[h],o[v]),j(r,a[v+1],i[h]),h++,v--;else if(c[$]===n[u])a[u]=C(i[$],o[u]),j(r,i[h],i[$]),$--,u++;else if(m===void 0&&(m=Wt(n,u,v),f=Wt(c,h,$)),m.has(c[h]))if(m.has(c[$])){let w=f.get(n[u]),lt=w!==void 0?i[w]:null;if(lt===null){let vt=j(r,i[h]);C(vt,o[u]),a[u]=vt}else a[u]=C(lt,o[u]),j(r,i[h],lt),i[w]=null;u++}else nt(i[$]),$--;else nt(i[h]),h++;for(;u<=v;){let w=j(r,a[v+1]);C(w,o[u]),a[u++]=w}for(;h<=$;){let w=i[h++];w!==null&&nt(w)}return this.ut=n,Bt(r,a),_}});var It={fresh:"",preview:"preview",stale:"being drawn",none:"not drawn"},P=class extends b{constructor(){super(...arguments);this.selected=[];this.dragged="";this.over=""}createRenderRoot(){return this}select(t,s){let i=s.ctrlKey||s.metaKey,o=this.selected.filter(c=>c!==t),n=i?o.length<this.selected.length?o:[...o,t]:[t];this.dispatchEvent(new CustomEvent("select",{detail:n}))}edit(t){this.dispatchEvent(new CustomEvent("edit",{detail:[t]}))}drop(t){let i=this.board.scenes.find(c=>c.shots.some(a=>a.shot===t)).shots.map(c=>c.shot),o=i.indexOf(this.dragged),n=i.indexOf(t);o>=0&&o!==n&&this.edit({kind:"reorder",target:this.dragged,[o<n?"after":"before"]:t}),this.dragged=this.over=""}mayDrop(t){return this.dragged!==""&&this.board.scenes.some(s=>[this.dragged,t.shot].every(i=>s.shots.some(o=>o.shot===i)))}shift(t,s){let o=this.board.scenes.find(c=>c.shots.some(a=>a.shot===t)).shots.map(c=>c.shot),n=o[o.indexOf(t)+s];n&&this.edit({kind:"reorder",target:t,[s>0?"after":"before"]:n})}keys(t){let s=[...this.querySelectorAll(".card")],i=s.indexOf(t.target);if(i<0)return;if(t.altKey&&(t.key==="ArrowLeft"||t.key==="ArrowRight")){t.preventDefault(),this.shift(s[i].dataset.shot,t.key==="ArrowLeft"?-1:1);return}let o=s.filter(c=>c.offsetTop===s[i].offsetTop).length,n={ArrowLeft:-1,ArrowRight:1,ArrowUp:-o,ArrowDown:o}[t.key];if(n!==void 0){t.preventDefault();let c=s[Math.min(Math.max(i+n,0),s.length-1)];c.focus(),this.selected.length&&this.select(c.dataset.shot,t)}else(t.key==="Enter"||t.key===" ")&&(t.preventDefault(),this.select(s[i].dataset.shot,t))}render(){return l`<div class="board" @keydown=${t=>this.keys(t)}>${this.board.scenes.map(t=>l`
        ${this.heading(t)}
        <div class="grid" role="list">${zt(t.shots,s=>s.shot,s=>this.card(s))}</div>`)}</div>`}heading(t){let s=t.omitted?"restore":"omit";return l`<div class="heading"><h2 id=${t.scene}>${t.title}${t.omitted?" (omitted)":""}</h2>
      <button class="quiet" @click=${()=>this.edit({kind:s,target:t.scene})}
        title=${t.omitted?"Bring the scene back":"Leave the scene out of the film"}>${t.omitted?"Restore":"Omit"}</button></div>`}card(t){let s=this.selected.includes(t.shot);return l`
      <div role="listitem">
        <div class=${Ut({card:!0,[t.state]:!0,chosen:s,omitted:t.omitted,over:this.over===t.shot})} tabindex="0" role="button" aria-pressed=${s}
          aria-label="${t.shot}, ${t.facts}" data-shot=${t.shot}
          draggable="true"
          @dragstart=${()=>this.dragged=t.shot}
          @dragend=${()=>this.dragged=this.over=""}
          @dragover=${i=>this.mayDrop(t)&&(i.preventDefault(),this.over=t.shot)}
          @drop=${i=>(i.preventDefault(),this.drop(t.shot))}
          @click=${i=>this.select(t.shot,i)}>
          <div class="picture" style="aspect-ratio: ${this.board.aspect}">
            ${t.picture?l`<img src=${t.picture} alt="" draggable="false" />`:d}
            ${t.omitted?l`<span class="state">omitted</span>`:It[t.state]?l`<span class="state">${It[t.state]}</span>`:d}
          </div>
          <div class="slate"><b>${t.shot}</b><span>${t.seconds.toFixed(1)} s</span></div>
          <div class="facts">${t.facts}</div>
          <p>${t.words}</p>
          ${t.speech.map(([i,o])=>l`<p class="speech"><b>${i}</b> ${o}</p>`)}
          <div class="marks">
            ${t.approved?l`<span class="approved">approved</span>`:d}
            ${t.notes?l`<span>${t.notes===1?"1 note":`${t.notes} notes`}</span>`:d}
            ${t.locked&&!t.approved?l`<span title="Locked">locked</span>`:d}
            ${t.takes>1?l`<span>${t.takes} takes</span>`:d}
            ${t.problems?l`<span class="warn">${t.problems} to check</span>`:d}
          </div>
        </div>
      </div>`}};p([y({attribute:!1})],P.prototype,"board",2),p([y({attribute:!1})],P.prototype,"selected",2),p([g()],P.prototype,"dragged",2),p([g()],P.prototype,"over",2),P=p([A("sb-board")],P);var Kt={ground:"Reading the script",materialize:"Casting and props",stage:"Sets, staging, motion, light",pack:"Packing scenes",camera:"Setting the cameras",frames:"Drawing the frames",motion:"Drawing the film",deliver:"Board, lists and Blender file"},D=class extends b{constructor(){super(...arguments);this.events=[];this.status=null;this.board=null}createRenderRoot(){return this}render(){let t=this.status,s=Object.keys(Kt).indexOf(t.stage);return l`
      <section class="crew">
        <ol class="stages">${Object.entries(Kt).map(([i,o],n)=>l`
          <li class=${n<s?"done":n===s?"now":""}>${o}
            ${n===s&&t.total?l`<progress max=${t.total} value=${t.step} aria-label=${o}></progress>`:d}</li>`)}
        </ol>
        ${t.error?l`<p class="bar wrong" role="alert">${t.error}</p>`:d}
        <p>${t.busy?l`<button @click=${()=>this.dispatchEvent(new Event("stop"))}>Stop</button>`:l`<button @click=${()=>this.dispatchEvent(new Event("back"))}>Back</button>`}</p>
        <div class="log" tabindex="0" role="log" aria-label="What the crew does">${this.events.filter(i=>i.kind!=="stage").slice(-120).reverse().map(i=>this.line(i))}</div>
        <div class="grid">${(this.board?.scenes??[]).flatMap(i=>i.shots).filter(i=>i.picture).map(i=>l`<img src=${i.picture} alt=${i.shot} />`)}</div>
      </section>
    `}line(t){let s=t.role.replaceAll("_"," "),i=t.score==null?d:l`<b class="score">${t.score.toFixed(1)}</b>`,o=t.details?.length?l`<ul>${t.details.map(n=>l`<li>${n}</li>`)}</ul>`:d;return l`<div class="event ${t.kind}"><span class="role">${s}</span> ${t.subject??""}
      <i>${t.kind}${t.turn?` (turn ${t.turn})`:""}</i> ${i} ${t.message??""}${o}</div>`}};p([y({attribute:!1})],D.prototype,"events",2),p([y({attribute:!1})],D.prototype,"status",2),p([y({attribute:!1})],D.prototype,"board",2),D=p([A("sb-crew")],D);var ce=[18,24,28,35,40,50,65,85,100,135],x=class extends b{constructor(){super(...arguments);this.shot="";this.details=null;this.words={}}createRenderRoot(){return this}async connectedCallback(){super.connectedCallback();let{camera:t}=await this.wire.call("vocabulary");this.words=Object.fromEntries(Object.entries(t).map(([s,i])=>[s,Object.keys(i)]))}willUpdate(t){(t.has("shot")||t.has("board"))&&this.ask()}async ask(){let t=await this.wire.call("shot",{shot:this.shot});t.shot===this.shot&&(this.details=t)}edit(...t){this.dispatchEvent(new CustomEvent("edit",{detail:t}))}camera(t){this.edit({kind:"camera",shot:this.shot,decision:t})}render(){let t=this.board.scenes.flatMap(i=>i.shots).find(i=>i.shot===this.shot),s=this.details?.shot===this.shot?this.details:null;return t?l`
      <aside class="inspector" aria-label="Shot ${this.shot}">
        <div class="head"><h2>${this.shot}</h2>
          <button aria-label="Close" @click=${()=>this.dispatchEvent(new Event("close"))}>×</button></div>
        <div class="picture ${t.state}" style="aspect-ratio: ${this.board.aspect}">
          ${t.picture?l`<img src=${t.picture} alt=${s?.description??""} />`:d}
        </div>
        ${s?this.form(s,t):l`<p>...</p>`}
      </aside>`:d}form(t,s){let i=t.locked.includes("camera");return l`
      <p>${t.description}</p>
      <fieldset ?disabled=${i}>
        <legend>Camera</legend>
        ${this.choice("Size","size",t.size)}
        ${this.choice("Angle","angle",t.angle)}
        ${this.choice("Move","movement",this.move(t))}
        <label>Lens <select @change=${o=>this.camera({lens:Number(o.target.value)})}>
          ${[...new Set([...ce,Math.round(t.lens)])].sort((o,n)=>o-n).map(o=>l`<option value=${o} ?selected=${o===Math.round(t.lens)}>${o} mm</option>`)}
        </select></label>
        <label>Seconds <input type="number" min="0.5" max="600" step="0.5" .value=${String(t.seconds)}
          @change=${o=>this.edit({kind:"duration",shot:this.shot,seconds:Number(o.target.value)})} /></label>
      </fieldset>
      ${t.decided.length?l`<p class="decided">You decided: ${t.decided.join(", ")}</p>`:d}
      <fieldset><legend>Takes</legend>
        ${t.takes.map(o=>l`<button class=${o.in_film?"chosen":""} title=${o.camera} ?disabled=${o.in_film}
          @click=${()=>this.edit({kind:"take",shot:this.shot,action:"choose",number:o.number})}>Take ${o.number}</button>`)}
        <button ?disabled=${i} @click=${()=>this.edit({kind:"take",shot:this.shot,action:"keep"})}>Keep, and try another</button>
      </fieldset>
      <p class="buttons">
        <button @click=${()=>this.edit({kind:"approve",shot:this.shot,approved:!t.approved})}>
          ${t.approved?"Withdraw approval":"Approve"}</button>
        <button ?disabled=${t.approved} @click=${()=>this.edit({kind:s.locked?"unlock":"lock",target:this.shot,parts:[]})}>
          ${s.locked?"Unlock the shot":"Lock the shot"}</button>
        <button @click=${()=>this.edit({kind:s.omitted?"restore":"omit",target:this.shot})}>
          ${s.omitted?"Restore":"Omit"}</button>
      </p>
      ${this.notes(t)}
      ${t.problems.length?l`<h3>To check</h3><ul>${t.problems.map(o=>l`<li>${o}</li>`)}</ul>`:d}
      <h3>Script</h3>
      ${t.lines.map(o=>l`<p class=${o.kind==="dialogue"?"speech":""}>
        ${o.speaker?l`<b>${this.board.cast[o.speaker]??o.speaker}</b> `:d}${o.text}</p>`)}
    `}notes(t){return l`<fieldset class="notes"><legend>Notes</legend>
      ${t.notes.map(s=>l`<label class=${s.resolved?"resolved":""}>
        <input type="checkbox" .checked=${s.resolved}
          @change=${()=>this.edit({kind:"note",shot:this.shot,action:s.resolved?"reopen":"resolve",number:s.number})} />
        <span>${s.author?l`<b>${s.author}</b> `:d}${s.text}</span></label>`)}
      <form @submit=${s=>this.note(s)}>
        <input aria-label="A note" placeholder="Write a note" maxlength="2000" autocomplete="off" /></form>
    </fieldset>`}note(t){t.preventDefault();let s=t.target.querySelector("input"),i=s.value.trim();i&&this.edit({kind:"note",shot:this.shot,action:"add",text:i}),s.value=""}move(t){let s=this.words.movement??[];return s.find(i=>i===t.movement)??s.find(i=>t.movement.startsWith(i))??t.movement}choice(t,s,i){let o=this.words[s]??[];return l`<label>${t} <select data-field=${s}
        @change=${n=>this.camera({[s]:n.target.value})}>
      ${[...new Set([...o,i])].map(n=>l`<option ?selected=${n===i}>${n}</option>`)}
    </select></label>`}};p([y({attribute:!1})],x.prototype,"board",2),p([y({attribute:!1})],x.prototype,"shot",2),p([y({attribute:!1})],x.prototype,"wire",2),p([g()],x.prototype,"details",2),p([g()],x.prototype,"words",2),x=p([A("sb-shot")],x);var T=class extends b{constructor(){super(...arguments);this.places=null;this.over=!1;this.look="board";this.animatic=!1}createRenderRoot(){return this}make(t,s){let i={script:t,text:s,look:this.look,animatic:this.animatic};this.dispatchEvent(new CustomEvent("make",{detail:i}))}async take(t){this.over=!1;let s=t?.[0];s&&this.make(s.name,await s.text())}render(){let{scripts:t,projects:s}=this.places??{scripts:[],projects:[]};return l`
      <section class="start">
        <label class="drop ${this.over?"over":""}"
          @dragover=${i=>(i.preventDefault(),this.over=!0)}
          @dragleave=${()=>this.over=!1}
          @drop=${i=>(i.preventDefault(),this.take(i.dataTransfer?.files))}>
          <b>Drop a script here</b>
          <span>Fountain, Final Draft, or plain prose; or choose a file</span>
          <input type="file" accept=".fountain,.fdx,.txt,.md" aria-label="Choose a script"
            @change=${i=>this.take(i.target.files)} />
        </label>
        <fieldset>
          <label>Look
            <select @change=${i=>this.look=i.target.value}>
              <option value="board">Board: lit and inked</option>
              <option value="pencil">Pencil</option>
              <option value="fast">Fast, for trying</option>
            </select>
          </label>
          <label><input type="checkbox" @change=${i=>this.animatic=i.target.checked} />
            With a film</label>
        </fieldset>
        ${s.length?l`<h2>Storyboards</h2><ul class="places">${s.map(i=>l`<li><button @click=${()=>this.dispatchEvent(new CustomEvent("open",{detail:i}))}>${i}</button></li>`)}</ul>`:d}
        ${t.length?l`<h2>Scripts</h2><ul class="places">${t.map(i=>l`<li><button @click=${()=>this.make(i)}>Make ${i}</button></li>`)}</ul>`:d}
      </section>
    `}};p([y({attribute:!1})],T.prototype,"places",2),p([g()],T.prototype,"over",2),p([g()],T.prototype,"look",2),p([g()],T.prototype,"animatic",2),T=p([A("sb-start")],T);var at=class{constructor(e,t,s){this.news=e;this.joined=t;this.lost=s;this.number=0;this.waiting=new Map;this.connect()}async call(e,t={}){await this.ready;let s=++this.number;return new Promise((i,o)=>{this.waiting.set(s,{done:i,failed:o}),this.socket.send(JSON.stringify({id:s,call:e,...t}))})}connect(){this.socket=new WebSocket(`ws://${location.host}/wire`),this.ready=new Promise(e=>this.socket.addEventListener("open",()=>e(),{once:!0})),this.socket.onopen=()=>this.joined(),this.socket.onmessage=e=>this.hear(JSON.parse(e.data)),this.socket.onclose=()=>{for(let e of this.waiting.values())e.failed(new Error("the connection to the studio broke"));this.waiting.clear(),this.lost(),setTimeout(()=>this.connect(),1e3)}}hear(e){if("news"in e){this.news(e);return}let t=this.waiting.get(e.id);this.waiting.delete(e.id),e.ok?t?.done(e.value):t?.failed(new Error(e.error))}};var de=400,E=class extends b{constructor(){super(...arguments);this.board=null;this.places=null;this.status=null;this.selected=[];this.events=[];this.said=null;this.connected=!0;this.wire=new at(t=>this.hear(t),()=>this.joined(),()=>this.connected=!1);this.keys=t=>{let s=t.target.closest("input, textarea, select");(t.ctrlKey||t.metaKey)&&t.key.toLowerCase()==="z"&&!s?(t.preventDefault(),this.step(t.shiftKey?"redo":"undo")):t.key==="/"&&!s?(t.preventDefault(),this.querySelector("#say")?.focus()):t.key==="Escape"&&(s?t.target.blur():this.selected=[])}}createRenderRoot(){return this}connectedCallback(){super.connectedCallback(),document.addEventListener("keydown",this.keys)}async joined(){this.connected=!0,this.places=await this.wire.call("places"),this.status=this.places.status,await this.look()}async look(){try{this.board=await this.wire.call("board"),document.title=`${this.board.title} - StoryBlender`;let t=new Set(this.board.scenes.flatMap(s=>s.shots.map(i=>i.shot)));this.selected=this.selected.filter(s=>t.has(s))}catch{this.board=null}}hear(t){t.news==="status"&&t.status&&(this.status=t.status),t.news==="event"&&t.event&&(this.events=[...this.events,t.event].slice(-de)),t.news==="event"&&t.event?.role==="frames"&&t.event.kind==="warning"&&this.say(t.event.message??"",!0),(t.news==="board"||t.news==="frames"||t.event?.role==="frames"&&this.status?.busy)&&this.look()}say(t,s=!1){this.said=t?{text:t,wrong:s}:null}async attempt(t){try{this.say(await t())}catch(s){this.say(s.message,!0)}}step(t){let s=t==="undo"?"Undone":"Done again";return this.attempt(async()=>`${s}: ${(await this.wire.call(t)).done}`)}edit(t){let s=this.board?.revision;return this.attempt(async()=>(await this.wire.call("apply",{edits:t,revision:s})).words)}instruct(t){t.preventDefault();let s=t.target.querySelector("#say"),i=s.value.trim();if(!i||!this.board)return;let o=i.includes(":")?"":`${this.selected.join(", ")}: `,n=this.board.revision;this.attempt(async()=>{let c=await this.wire.call("instruct",{words:o+i,revision:n});return s.value="",c.words})}make(t){return this.events=[],this.board=null,this.attempt(async()=>(this.status=await this.wire.call("make",t),""))}render(){return l`
      <header>
        <button class="home" @click=${()=>this.leave()} title="Scripts and projects">StoryBlender</button>
        ${this.board?l`<h1>${this.board.title}</h1><span class="summary">${this.board.summary}</span>`:d}
        <span class="space"></span>
        ${this.board?.made?this.tools(this.board):d}
      </header>
      ${this.connected?d:l`<p class="bar wrong" role="alert">The studio does not answer. Start it again; nothing is lost.</p>`}
      ${this.said?l`<p class="bar ${this.said.wrong?"wrong":""}" role="status">${this.said.text}</p>`:d}
      <main>${this.view()}</main>
    `}tools(t){return l`
      <form class="say" @submit=${s=>this.instruct(s)}>
        <input id="say" aria-label="Say it" autocomplete="off" ?disabled=${!this.selected.length}
          placeholder=${this.selected.length?`${this.selected.join(", ")}: closer, low angle ...`:"Select a shot, then say what you want"} />
      </form>
      <button @click=${()=>this.step("undo")} ?disabled=${!t.undo} title=${t.undo||"Nothing to undo"}>Undo</button>
      <button @click=${()=>this.step("redo")} ?disabled=${!t.redo} title=${t.redo||"Nothing to redo"}>Redo</button>
      ${t.files.length?l`<details class="menu"><summary>Deliver</summary>
            ${t.files.map(s=>l`<a href="/files/${s}" download>${s}</a>`)}</details>`:d}
    `}view(){return this.status?.busy||this.status?.error&&!this.board?l`<sb-crew .events=${this.events} .status=${this.status} .board=${this.board}
        @stop=${()=>this.attempt(async()=>(await this.wire.call("cancel"),"Stopped; make it again to go on."))}
        @back=${()=>this.leave()}></sb-crew>`:this.board?l`
      <sb-board .board=${this.board} .selected=${this.selected}
        @edit=${t=>this.edit(t.detail)}
        @select=${t=>this.selected=t.detail}></sb-board>
      ${this.selected.length===1?l`<sb-shot .board=${this.board} .shot=${this.selected[0]} .wire=${this.wire}
            @edit=${t=>this.edit(t.detail)}
            @close=${()=>this.selected=[]}></sb-shot>`:d}
    `:l`<sb-start .places=${this.places}
        @make=${t=>this.make(t.detail)}
        @open=${t=>this.attempt(async()=>(this.board=await this.wire.call("open",{project:t.detail}),""))}></sb-start>`}async leave(){this.board=null,this.status=null,this.selected=[],this.places=await this.wire.call("places"),document.title="StoryBlender"}};p([g()],E.prototype,"board",2),p([g()],E.prototype,"places",2),p([g()],E.prototype,"status",2),p([g()],E.prototype,"selected",2),p([g()],E.prototype,"events",2),p([g()],E.prototype,"said",2),p([g()],E.prototype,"connected",2),E=p([A("sb-studio")],E);export{E as Studio};
/*! Bundled license information:

@lit/reactive-element/css-tag.js:
  (**
   * @license
   * Copyright 2019 Google LLC
   * SPDX-License-Identifier: BSD-3-Clause
   *)

@lit/reactive-element/reactive-element.js:
lit-html/lit-html.js:
lit-element/lit-element.js:
@lit/reactive-element/decorators/custom-element.js:
@lit/reactive-element/decorators/property.js:
@lit/reactive-element/decorators/state.js:
@lit/reactive-element/decorators/event-options.js:
@lit/reactive-element/decorators/base.js:
@lit/reactive-element/decorators/query.js:
@lit/reactive-element/decorators/query-all.js:
@lit/reactive-element/decorators/query-async.js:
@lit/reactive-element/decorators/query-assigned-nodes.js:
lit-html/directive.js:
lit-html/directives/repeat.js:
  (**
   * @license
   * Copyright 2017 Google LLC
   * SPDX-License-Identifier: BSD-3-Clause
   *)

lit-html/is-server.js:
  (**
   * @license
   * Copyright 2022 Google LLC
   * SPDX-License-Identifier: BSD-3-Clause
   *)

@lit/reactive-element/decorators/query-assigned-elements.js:
  (**
   * @license
   * Copyright 2021 Google LLC
   * SPDX-License-Identifier: BSD-3-Clause
   *)

lit-html/directives/class-map.js:
  (**
   * @license
   * Copyright 2018 Google LLC
   * SPDX-License-Identifier: BSD-3-Clause
   *)

lit-html/directive-helpers.js:
  (**
   * @license
   * Copyright 2020 Google LLC
   * SPDX-License-Identifier: BSD-3-Clause
   *)
*/
